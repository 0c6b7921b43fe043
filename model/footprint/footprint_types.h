// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/normal/normal_types.h"

namespace shading {

// Twins of the typedefs in rtl/pkg/footprint_pkg.sv: where a pixel's samples lie.
using Margin = S<3, 28>;  // weighted barycentric of the enlarged triangle, negative outside
using Margins = std::array<Margin, 3>;

// Samples of a pixel, in the order in which they are taken: the centre, then + and - of the pairs.
enum class FootprintPattern {
  kCentre,  // the centre
  kTwo,     // 1 pair
  kFour,    // 2 pairs
  kEight    // the centre, which counts twice, and 3 pairs
};
inline constexpr int kFootprintPatterns = 4;
inline constexpr int kMostSamples = 7;  // positions of kEight

constexpr bool HasCentre(FootprintPattern pattern) {
  return pattern == FootprintPattern::kCentre || pattern == FootprintPattern::kEight;
}
// Positions, which are cycles of a pixel.
constexpr int SampleCount(FootprintPattern pattern) {
  switch (pattern) {
    case FootprintPattern::kCentre: return 1;
    case FootprintPattern::kTwo: return 2;
    case FootprintPattern::kFour: return 4;
    default: return kMostSamples;
  }
}

struct FootprintOffset {
  std::array<Quantity, 3> normal;
  Margins margin;
};

// The footprint of the pixels of one triangle. Offsets that the pattern does not use are 0.
struct Footprint {
  FootprintPattern pattern = FootprintPattern::kCentre;
  std::array<FootprintOffset, 3> offset;  // from the centre to a sample
  Margins margin_dx;                      // from pixel to pixel
};

}  // namespace shading
