// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/light/specular_table.h"

namespace shading {

// A quadratic and where it starts: f = value + (slope + curvature d) d with d = u - start. Four
// words, so that a look-up is one load of a vector register.
struct alignas(16) PlacedSegment {
  int32_t start, value, slope, curvature;
};

// Segments of 2^place_bits ulp of u.
template <size_t kSegments>
constexpr std::array<PlacedSegment, kSegments> Placed(
    const std::array<QuadraticSegment, kSegments>& table, int place_bits) {
  std::array<PlacedSegment, kSegments> placed = {};
  for (size_t i = 0; i < kSegments; ++i) {
    placed[i] = {static_cast<int32_t>(i) << place_bits, table[i].value, table[i].slope,
                 table[i].curvature};
  }
  return placed;
}

}  // namespace shading
