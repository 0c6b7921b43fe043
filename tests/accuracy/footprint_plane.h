// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/footprint/footprint_types.h"

namespace shading::accuracy {

// Errors of a pixel's highlight, full scale, against the mean over 4096 points of its ellipse: the
// largest and the root of the mean square over highlights up to 4 / sqrt(n) and the turn away;
// n = 1 is diffuse light, up to beyond the terminator.
struct FootprintErrors {
  double max = 0, rms = 0;  // codes
};

struct PlaneErrors {
  std::array<FootprintErrors, kFootprintPatterns> pattern;  // of 1, 2, 4, 8 samples
  FootprintPattern chosen = FootprintPattern::kCentre;      // for half a code
};

// A normal that turns evenly, by `turn` degrees along the major semi-axis of the ellipse and by
// turn / ratio along the minor one; shininess n. The units' arithmetic. `grid` highlights a side.
PlaneErrors ErrorsOnPlane(double ratio, double turn, int n, int grid);

}  // namespace shading::accuracy
