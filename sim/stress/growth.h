// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace shading::stress {

// Paper 000 (7) as printed, and the scaled recurrence of slerp_recurrence, whose multiplier takes
// 10 bits less than its state has; products rounded to nearest or truncated.
enum class Form { kScaled, kScaledTruncated, kPaper, kPaperTruncated };

// The worst pixel of a span that turns by `degrees`, several phases, in codes of amplitude 255; 0
// where a step is over a quarter of a turn.
double WorstOfTurn(Form form, double degrees, int fraction_bits, int pixels, int phases);

// The worst error found over the length of the span, in codes of 255, one curve a format.
struct Growth {
  std::string form;  // and rounding
  int fraction_bits;
  std::vector<std::pair<double, double>> points;  // pixels, codes
  std::string paper = "000";
};
std::vector<Growth> GrowthCurves(bool quick);

// One cell of a heat map: angle of the whole span against pixels.
struct Heat {
  double degrees;
  int pixels;
  double codes;
};
// Angles of 0.001 .. 179.9 degrees, spans of 4..4096 pixels.
std::vector<Heat> HeatMap(Form form, int fraction_bits, bool quick);

// Smallest turn in degrees that bends a span of `pixels`; smaller ones are drawn as straight lines.
double DeadZone(int fraction_bits, int pixels);

}  // namespace shading::stress
