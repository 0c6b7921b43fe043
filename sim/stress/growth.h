// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace shading::stress {

// The worst error found over the length of the span, in codes of 255, one curve a format.
struct Growth {
  std::string form;  // and rounding
  int fraction_bits;
  std::vector<std::pair<double, double>> points;  // pixels, codes
};
std::vector<Growth> GrowthCurves(bool quick);

// One cell of a heat map: angle of the whole span against pixels.
struct Heat {
  double degrees;
  int pixels;
  double codes;
};
// Of slerp_recurrence and slerp_paper with F fraction bits; angles of 0.001 .. 179.9 degrees.
std::vector<Heat> HeatMap(bool paper, int fraction_bits, bool quick);

// Smallest turn in degrees that bends a span of `pixels`; smaller ones are drawn as straight lines.
double DeadZone(int fraction_bits, int pixels);

}  // namespace shading::stress
