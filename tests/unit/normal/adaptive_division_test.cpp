// SPDX-License-Identifier: Apache-2.0
//
// How adaptive_normalizer divides a span: its tables, the numbers of paper 002, and corner cases.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "model/normal/adaptive_normalizer.h"
#include "model/normal/adaptive_normalizer_table.h"
#include "tests/unit/normal/adaptive_accuracy.h"

namespace shading {
namespace {

constexpr auto kSphere = AdaptiveKind::kSphere;
const auto kUnread = [](int, const PixelNormal&) {};

int64_t Rounded(Real value) {
  return std::llround(std::ldexp(value, adaptive_normalizer::kFraction));
}

// Each quadratic meets its function where t = 0, c/(1+c) and 2c/(1+c), c = cos(30 deg). Returns the
// largest error up to x = `most`.
Real ExpectTable(const adaptive_normalizer::Table<adaptive_normalizer::kSegments>& table,
                 Real (*f)(Real), Real most) {
  const Real width = 1.0L / 64, c = std::sqrt(3.0L) / 2, t1 = c / (1 + c), t2 = 2 * t1;
  Real worst = 0;
  for (size_t i = 0; i < table.size(); ++i) {
    const Real start = static_cast<Real>(i) * width, f0 = f(start);
    EXPECT_EQ(table[i].value, Rounded(f0)) << i;
    if (i + 1 == table.size()) break;
    const Real d1 = (f(start + t1 * width) - f0) / t1, d2 = (f(start + t2 * width) - f0) / t2;
    const Real curvature = (d2 - d1) / (t2 - t1), slope = d1 - curvature * t1;
    EXPECT_LE(std::abs(table[i].slope - Rounded(slope)), 1) << i;
    EXPECT_LE(std::abs(table[i].curvature - Rounded(curvature)), 1) << i;
    for (int64_t t = 0; t < 64 && start < most; ++t) {
      const Real value = std::ldexp(static_cast<Real>(normal_setup::Evaluate(table[i], t, 6)), -32);
      worst = std::max(worst, std::abs(value - f(start + std::ldexp(Real(t), -12))));
    }
  }
  return worst;
}

TEST(AdaptiveDivision, TablesFollowTheirFunctions) {
  const auto divisor = [](Real x) { return 1 / std::sqrt(4 - 2 * x); };
  const auto half = [](Real x) { return 1 - std::sqrt(1 - x / 2); };
  EXPECT_LE(ExpectTable(adaptive_normalizer::kDivisor, divisor, 1.0L), std::ldexp(1.0L, -24));
  EXPECT_LE(ExpectTable(adaptive_normalizer::kDivisor, divisor, 1.5L), std::ldexp(1.0L, -20));
  EXPECT_LE(ExpectTable(adaptive_normalizer::kHalfAngle, half, 1.5L), std::ldexp(1.0L, -22));
}

// 1 - |N| of the middle when level j is not divided: 1 - z_j / 2.
Real DeviationOf(const AdaptiveNormalizer& model, int level) {
  return 1 - std::ldexp(1.0L, 31) / static_cast<Real>(model.Divisor(level));
}

// delta(1/2) / delta(1/4) = 4 cos^2(psi/8) = 4 - psi^2/16 + ..., and the remainder is positive.
TEST(AdaptiveDivision, DeviationsShrinkAsThePaperSays) {
  std::mt19937 random(1);
  for (int degrees = 5; degrees <= 120; degrees += 5) {
    const Real turn = degrees * kDegree;
    const AdaptiveNormalizer model(kSphere, SpanOf(RandomPlane(random), turn, 3).normal, 257, {});
    for (int level = 0; level < 3; ++level) {
      const Real psi = std::ldexp(turn, -level), cosine = std::cos(psi / 8);
      const Real ratio = DeviationOf(model, level) / DeviationOf(model, level + 1);
      const Real noise = std::ldexp(1.0L, degrees > 90 ? -20 : -24) / DeviationOf(model, level + 1);
      ASSERT_LE(std::abs(ratio - 4 * cosine * cosine), 4 * noise) << degrees;
      ASSERT_GT(ratio, 4 - psi * psi / 16 - 4 * noise) << degrees;
      ASSERT_LT(ratio, 4 + 4 * noise) << degrees;
    }
  }
}

// The largest deviation of a row that is not divided: 4 % at 32 degrees, 1 % at 16. z_1 at 90
// degrees leaves 29.3 %, the most that the paper has.
TEST(AdaptiveDivision, DeviationsOfThePaper) {
  std::mt19937 random(1);
  for (const auto& [degrees, deviation] : {std::pair<int, double>{32, 0.0387}, {16, 0.00973}}) {
    const SpanCommand span = SpanOf(RandomPlane(random), degrees * kDegree, 257);
    Real worst = 0;
    const auto model = VisitPixels(kSphere, span, AngleLimit::FromRaw(AngleLimit::kMaxRaw),
                                   [&](int, const PixelNormal& normal) {
                                     Real square = 0;
                                     for (const PixelNormalComponent c : normal) {
                                       const Real value = c.ToReal();
                                       square += value * value;
                                     }
                                     worst = std::max(worst, 1 - std::sqrt(square));
                                   });
    EXPECT_EQ(model.normalisations(), 0);
    EXPECT_NEAR(static_cast<double>(worst), deviation, 0.005 * deviation);
    EXPECT_NEAR(static_cast<double>(DeviationOf({kSphere, span.normal, 257, {}}, 0)), deviation,
                0.005 * deviation);
  }
  const SpanCommand quarter = SpanOf(RandomPlane(random), kQuarterTurn, 257);
  const AdaptiveNormalizer model(kSphere, quarter.normal, 257, {});
  EXPECT_NEAR(static_cast<double>(DeviationOf(model, 0)), 0.2929, 0.0001);
}

// Normalisations of 257 pixels: the 2^J - 1 nodes between the ends, J levels until the angle is at
// most 2 acos(1 - tol/n). The ends, which the paper counts, come with the span.
TEST(AdaptiveDivision, SkipsWhatTheStudySays) {
  std::mt19937 random(1);
  for (const auto& [tolerance, n] : {std::pair<Real, int>{0.5L, 1},
                                     {0.5L, 8},
                                     {0.5L, 32},
                                     {0.5L, 128},
                                     {2.55L, 32},
                                     {10.2L, 128}}) {
    const Real tol = tolerance / 255;
    const Real part = n == 1 ? 2 * std::acos(1 - tol) : std::acos(1 - 4 * tol / n);
    for (const int degrees : {5, 10, 15, 30, 60, 90, 120}) {
      const int levels =
          std::max(0, static_cast<int>(std::ceil(std::log2(degrees * kDegree / part))));
      const SpanCommand span = SpanOf(RandomPlane(random), degrees * kDegree, 257);
      const auto model = VisitPixels(kSphere, span, LimitOf(tolerance, n), kUnread);
      EXPECT_EQ(model.levels(), levels) << degrees << " degrees, n = " << n;
      EXPECT_EQ(model.normalisations(), (1 << std::min(levels, 8)) - 1) << degrees << ", " << n;
      EXPECT_EQ(model.skipped(), 257 - model.normalisations());
    }
  }
}

TEST(AdaptiveDivision, LimitFollowsToleranceAndShininess) {
  for (const int t : {0, 1, 77, 2048, 4096, 41779, 65535}) {
    const Real tol = t / Real(4096 * 255);
    const auto expect = [&](AngleLimit limit, Real real) {
      EXPECT_EQ(limit.raw(), static_cast<int64_t>(std::floor(std::ldexp(real, 30)))) << t;
    };
    for (const int n : {128, 129, 255, 256, 1000, 16384, 32768}) {
      const auto shininess = Shininess::FromRaw(n);
      const auto tolerance = Tolerance::FromRaw(t);
      expect(AdaptiveNormalizer::LimitOf(tolerance, shininess, false), 4 * tol - 2 * tol * tol);
      expect(AdaptiveNormalizer::LimitOf(tolerance, shininess, true),
             n == 128 ? 4 * tol - 2 * tol * tol : 4 * tol / std::max<Real>(2, n / 128.0L));
      expect(AdaptiveNormalizer::LimitOf(tolerance, shininess, true, Lighting::kPhong),
             tol / (n / 128.0L));
    }
  }
}

// First and last pixel are the ends; a row of one or two pixels is nothing else.
TEST(AdaptiveDivision, EndsStay) {
  std::mt19937 random(1);
  for (int i = 0; i < 4000; ++i) {
    const int length = i % 4 ? RandomAdaptiveLength(2048, random) : 1 + i / 4 % 2;
    const SpanCommand span =
        SpanOf(RandomPlane(random), RandomTurnUpTo(120 * kDegree, random), length);
    int pixels = 0;
    const auto near = [&](const PixelNormal& normal, size_t end) {
      for (size_t c = 0; c < 3; ++c) {
        ASSERT_LE(std::abs(normal[c].ToReal() - span.normal[end][c].ToReal()), std::ldexp(1, -24));
      }
    };
    const auto model =
        VisitPixels(kSphere, span, RandomLimit(random), [&](int pixel, const PixelNormal& normal) {
          if (pixel == 0) near(normal, 0);
          if (pixel > 0 && pixel == length - 1) near(normal, 1);
          ++pixels;
        });
    ASSERT_EQ(pixels, length);
    if (length <= 2) {
      ASSERT_EQ(model.normalisations(), 0);
    }
  }
}

TEST(AdaptiveDivision, EqualNormalsAreOneSegment) {
  std::mt19937 random(1);
  const SpanCommand span = SpanOf(RandomPlane(random), 0, 4096);
  AdaptiveNormalizer model(kSphere, span.normal, span.length, {});
  AdaptiveSegment segment;
  ASSERT_TRUE(model.Next(&segment));
  EXPECT_EQ(segment.count, 4096);
  EXPECT_EQ(segment.steps, 1);
  EXPECT_FALSE(model.Next(&segment));
  EXPECT_EQ(model.skipped(), 4096);
}

// A limit that no angle meets: every pixel of a row of 2^k steps becomes a node, none twice; of any
// row at most 2^12 parts.
TEST(AdaptiveDivision, ZeroLimitNormalisesEveryPixel) {
  std::mt19937 random(1);
  for (int steps = 2; steps <= 2048; steps *= 2) {
    const SpanCommand span = SpanOf(RandomPlane(random), 90 * kDegree, steps + 1);
    const auto model = VisitPixels(kSphere, span, {}, kUnread);
    EXPECT_EQ(model.levels(), AdaptiveNormalizer::kMostLevels);
    EXPECT_EQ(model.normalisations(), steps - 1) << steps;
  }
  const SpanCommand longest = SpanOf(RandomPlane(random), 90 * kDegree, 4096);
  EXPECT_EQ(VisitPixels(kSphere, longest, {}, kUnread).normalisations(), 4095);
}

}  // namespace
}  // namespace shading
