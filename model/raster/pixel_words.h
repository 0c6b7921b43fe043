// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstring>

#include "model/intensity/flat_color.h"
#include "model/raster/pixel_walker.h"
#include "model/shading_types.h"

namespace shading {

// A pixel is written as two words, its fields from the lowest byte up: fewer and wider stores.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "Pixel is written in words");

inline void WritePosition(const PixelWalker& walker, Pixel* pixel) {
  const uint64_t word = walker.x() | static_cast<uint64_t>(walker.y()) << 16 |
                        static_cast<uint64_t>(walker.z()) << 32;
  std::memcpy(&pixel->x, &word, sizeof word);
}

// Clears `last`, too. Few pixels need a clamp, so one test serves three channels.
inline void WriteColor(int64_t r, int64_t g, int64_t b, Pixel* pixel) {
  if (((r | g | b) & ~Code::kMaxRaw) != 0) {
    r = ClampCode(r);
    g = ClampCode(g);
    b = ClampCode(b);
  }
  const auto word = static_cast<uint32_t>(r | g << 8 | b << 16);
  std::memcpy(&pixel->r, &word, sizeof word);
}

}  // namespace shading
