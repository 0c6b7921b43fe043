// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/light/quadratic_table.h"
#include "model/light/rgb_combine.h"

namespace shading {

// What the light of a pixel takes from frame and material.
struct LightConstants {
  bool phong = false;
  bool has_specular = false;
  int64_t l_dot_v = 0;
  uint32_t shininess = 0;
  int32_t least_visible = 0;  // cosines below show no highlight; 1..2^30
  std::array<RgbCombine::Channel, 3> channel = {};
};

// Neighbouring pixels that are lit together: the passes of PixelLight as straight loops, each over
// arrays of one number, so that they run in vector registers. Pixel by pixel the arithmetic is that
// of SpecularCosine, SpecularMath and RgbCombine. Cosines are raw, with 30 fraction bits.
class PixelLightBlock {
 public:
  static constexpr int kSize = 64;
  struct Counts {
    int unlit, no_highlight;
  };

  void SetCosines(size_t i, const LightCosines& cosines) {
    n_dot_l_[i] = static_cast<int32_t>(cosines.n_dot_l.raw());
    specular_[i] = static_cast<int32_t>(cosines.n_dot_h_or_v.raw());
  }
  // The light of pixels 0..count-1, count 1..kSize.
  Counts Shade(const LightConstants& constants, size_t count);

  // Red in the lowest byte, then green and blue; the highest is 0.
  uint32_t codes(size_t i) const { return codes_[i]; }

 private:
  static constexpr size_t kGroup = 16;  // loops run over whole groups and need no remainder
  template <typename T>
  using PerPixel = std::array<T, kSize>;
  using Cosines = std::array<int32_t, kSize + kGroup>;  // a group may start at any pixel
  struct Passes;

  alignas(64) Cosines n_dot_l_;
  alignas(64) Cosines specular_;           // N.H or N.V, then the specular cosine
  alignas(64) PerPixel<int32_t> octaves_;  // zeros of the specular cosine, then octaves
  alignas(64) PerPixel<int32_t> place_;    // u, then g
  alignas(64) PerPixel<PlacedSegment> segment_;
  alignas(64) PerPixel<int32_t> highlight_;
  alignas(64) PerPixel<uint32_t> codes_;
};

}  // namespace shading
