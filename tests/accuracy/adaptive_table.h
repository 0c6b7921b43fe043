// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "tests/accuracy/worst_search.h"

namespace shading::accuracy {

// Errors of the adaptive methods, from the normals at the ends of a span to cosine and power,
// before the code is rounded: docs/adaptive.md.
inline constexpr std::array<double, 4> kTolerances = {0.5, 1, 2.55, 10.2};  // codes
inline constexpr std::array<int, 4> kAdaptiveShininess = {1, 8, 32, 128};
// Pixels of a span: 2^k, one more, and others.
inline constexpr std::array<int, 8> kAdaptiveLengths = {3, 5, 16, 64, 100, 256, 1025, 2048};
inline constexpr double kMostDegrees = 120;
inline constexpr double kFixedPoint = 0.2;  // codes promised beyond the tolerance

struct AdaptiveWorst {
  double lsb = 0;
  double degrees = 0;
  int length = 0;
};

// Over all lengths and angles, against slerp, or Phong for adaptive-chord.
AdaptiveWorst WorstAdaptive(Method method, double tolerance, int shininess);
// Over lengths just above 2^k steps, at one angle.
AdaptiveWorst WorstExtended(double degrees, int shininess);

// (R.V)^n with L = V, of adaptive against slerp.
double WorstReflected(double tolerance, int shininess);

// The lines of the tables of docs/adaptive.md.
std::vector<std::string> GuaranteeTable();
std::vector<std::string> ExtensionTable();
std::vector<std::string> ChordTable();

}  // namespace shading::accuracy
