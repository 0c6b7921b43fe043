// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace shading::sim {

// The frame buffer, row by row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::array<uint8_t, 3>> code;  // displayed intensity, red, green, blue
  std::vector<uint8_t> covered;              // not 0 where a triangle was drawn
};

// The format follows the extension.
// - png tif tiff bmp tga jpg jpeg ppm: the codes in 8 bits, with alpha 255 where covered, else
//   black with alpha 0. jpg and ppm have no alpha; jpg is lossy.
// - exr hdr: code / 255 as linear float with alpha 1 or 0; hdr has no alpha and rounds to RGBE.
// The file is whole or absent, see AtomicFile. Throws std::runtime_error, one line.
void WriteImage(const std::string& path, const Image& image);

// The same as PNG, in memory.
std::string EncodePng(const Image& image);

// Throws what WriteImage would for the extension, before any work is done.
void CheckImageExtension(const std::string& path);

}  // namespace shading::sim
