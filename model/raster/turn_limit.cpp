// SPDX-License-Identifier: Apache-2.0
#include "model/raster/turn_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shading {
namespace {

double Brightest(const Rgb& color) {
  double most = 0;
  for (const Reflectance r : color) most = std::max(most, r.ToReal());
  return most;
}

// Beyond it the errors rise faster than the rules.
constexpr double kMostDegrees = 75;

// The largest angle whose error, which rises with it, stays within `tolerance`.
template <typename Error>
double LargestAngle(const Error& error, double tolerance) {
  double low = 0, high = kMostDegrees;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    (error(middle) <= tolerance ? low : high) = middle;
  }
  return low;
}

}  // namespace

double TurnLimitDegrees(Method method, const Material& material, double tolerance) {
  const double kd = Brightest(material.diffuse), ks = Brightest(material.specular);
  const double n = material.shininess.ToReal();
  if (255 * (kd + ks) <= tolerance) return 180;
  const double highlight = std::max(0.043 * n, 0.0218 * std::pow(n, 1.5));
  const auto quad = [&](double s) { return (0.036 * kd + highlight * ks) * std::pow(s / 10, 3); };
  const auto gouraud = [&](double s) { return 1.35 * (kd + ks * n) * std::pow(s / 10, 2); };
  const double one_code = 22.5 * std::pow(8 / std::max(n, 8.0), 0.21);
  const auto cosine = [&](double s) {
    return 0.036 * kd * std::pow(s / 10, 3) + ks * std::pow(s / one_code, s < one_code ? 3.2 : 4.0);
  };
  if (method == Method::kFootprintPaper) return 30;
  if (method == Method::kGouraud) return LargestAngle(gouraud, tolerance);
  if (method == Method::kQuadCosine) {
    return std::max(LargestAngle(cosine, tolerance), LargestAngle(quad, tolerance));
  }
  if (IsQuadRow(method) || method == Method::kQuadSplit) return LargestAngle(quad, tolerance);
  return 180;
}

int64_t TurnLimit(Method method, const Material& material, Tolerance tolerance) {
  constexpr double kRadians = 3.14159265358979323846 / 180;
  const double degrees = TurnLimitDegrees(method, material, tolerance.ToReal());
  if (degrees >= 180) return std::numeric_limits<int64_t>::max();
  const double angle = std::floor(degrees * 1024) / 1024;
  const double half_chord = std::sin(angle * kRadians / 2);
  // 4 sin^2 of half the angle in 2^-28, as 2^-44.
  constexpr int kFine = 2 * NormalComponent::kFraction - 28;
  return static_cast<int64_t>(std::ldexp(half_chord * half_chord, 30)) << kFine;
}

}  // namespace shading
