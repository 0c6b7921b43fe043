// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/intensity/seed_stimulus.h"

namespace shading {

// Pixels for which the second-order units state their errors.
inline constexpr int kBoundedLength = 2048;

// A seed from raw numbers of any size, which wrap as registers do.
inline ChannelSeed WrappedSeed(int64_t first, int64_t second, int64_t difference,
                               int64_t curvature) {
  return {IntensityAcc::Wrap(first), IntensityAcc::Wrap(second), IntensityAcc::Wrap(difference),
          IntensityAcc::Wrap(curvature)};
}
// The seed of a curve through I(0) and I(1).
inline ChannelSeed Curve(int64_t first, int64_t second, int64_t curvature) {
  return WrappedSeed(first, second, second - first, curvature);
}

// 2^26 I(t) of first + t difference + t (t - 1) / 2 curvature, without a recurrence and without a
// register that could wrap.
inline Int128 CurveAt(Int128 first, Int128 difference, Int128 curvature, int t) {
  return first + t * difference + curvature * (static_cast<int64_t>(t) * (t - 1) / 2);
}
inline Int128 CurveAt(const ChannelSeed& seed, int t) {
  return CurveAt(seed.first.raw(), seed.difference.raw(), seed.curvature.raw(), t);
}

// Half an ulp of S9.26, less a 65536th ulp: what is off by it rounds back.
inline double AlmostHalfUlp() {
  return std::ldexp(0.5 - std::ldexp(1, -16), -IntensityAcc::kFraction);
}

// A real curve I(t) = A t^2 + D t + F. F contains the half code that makes truncation round. The
// seeds differ in what they round; whatever else a seed has to hold follows without a rounding.
struct RealCurve {
  double a, d, f;

  static RealCurve Through(double first, double second, double a) {
    return {a, second - first - a, first};
  }
  static RealCurve Through3(double first, double second, double third) {
    return Through(first, second, (first - 2 * second + third) / 2);
  }
  static RealCurve FromDifferences(double first, double difference, double a) {
    return {a, difference - a, first};
  }
  long double At(int t) const { return (static_cast<long double>(a) * t + d) * t + f; }

  // Rounds I(0), I(1) and A.
  ChannelSeed SeedOfTwoValues() const { return Curve(Round(At(0)), Round(At(1)), 2 * Round(a)); }
  // Rounds I(0), I(1) - I(0) and 2A, or A.
  ChannelSeed SeedOfDifferences() const { return DifferenceSeed(Round(2.0L * a)); }
  ChannelSeed SeedOfDifferenceAndA() const { return DifferenceSeed(2 * Round(a)); }
  // Rounds I(0), I(1), I(2) and A: I(2) stands in the seed as second + difference + curvature.
  ChannelSeed SeedOfThreeValues() const {
    const int64_t second = Round(At(1)), curvature = 2 * Round(a);
    return WrappedSeed(Round(At(0)), second, Round(At(2)) - second - curvature, curvature);
  }

 private:
  static int64_t Round(long double real) {
    return std::llround(std::ldexp(real, IntensityAcc::kFraction));
  }
  ChannelSeed DifferenceSeed(int64_t curvature) const {
    const int64_t first = Round(At(0)), difference = Round(static_cast<long double>(a) + d);
    return WrappedSeed(first, first + difference, difference, curvature);
  }
};

// |accumulator - I(t)| in codes.
inline double Drift(Int128 accumulator, const RealCurve& curve, int t) {
  const long double real = std::ldexp(curve.At(t), IntensityAcc::kFraction);
  return static_cast<double>(
      std::ldexp(std::abs(static_cast<long double>(accumulator) - real), -IntensityAcc::kFraction));
}

// Six intensities in 0..255 span a surface in -85..340. Ends and middle of the curve lie there, a
// quarter of them at its limits.
inline RealCurve RandomCurve(std::mt19937& random, int length = kBoundedLength) {
  std::uniform_real_distribution<double> level(-85, 340);
  const auto pick = [&] {
    const double inside = level(random);
    return 0.5 + (random() % 4 ? inside : inside < 127.5 ? -85 : 340);
  };
  const double end_t = std::max(2, length - 1);
  for (;;) {
    const double first = pick(), middle = pick(), last = pick();
    const double a = 2 * (first - 2 * middle + last) / (end_t * end_t);
    const RealCurve curve = {a, (last - first) / end_t - a * end_t, first};
    const double peak_t = -curve.d / (2 * a);
    if (!(peak_t > 0 && peak_t < end_t)) return curve;
    const double peak = curve.f - curve.d * curve.d / (4 * a);
    if (peak >= -84.5 && peak <= 340.5) return curve;
  }
}

// The largest drift(curve) that hill-climbing from random curves finds: it moves the numbers of the
// curve by fractions of the ulp to which they are rounded.
template <typename Function>
double WorstDrift(Function drift, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  double worst = 0;
  for (int start = 0; start < 20; ++start) {
    RealCurve best = RandomCurve(random);
    double best_drift = drift(best);
    for (int step = 0; step < 4000; ++step) {
      const double reach = std::ldexp(1, -26 - static_cast<int>(random() % 10));
      const RealCurve next = {best.a + reach * unit(random), best.d + reach * unit(random),
                              best.f + reach * unit(random)};
      const double next_drift = drift(next);
      if (next_drift <= best_drift) continue;
      best = next;
      best_drift = next_drift;
    }
    worst = std::max(worst, best_drift);
  }
  return worst;
}

}  // namespace shading
