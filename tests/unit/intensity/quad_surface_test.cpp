// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tb/dut/quad_surface_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/intensity/seed_stimulus.h"

namespace shading {
namespace {

constexpr int kSpans = 5000;
constexpr int kBoundedLength = 2048;  // pixels for which the contract states its error
using Dut = tb::QuadSurfaceDut;

ChannelSeed Curve(int64_t first, int64_t second, int64_t curvature) {
  return SeedOf(first, second, 0, curvature);
}

// I(t) of the seed, without a recurrence and without a register that could wrap:
// I(0) + t (I(1) - I(0)) + t (t - 1) / 2 * 2A.
Int128 ClosedForm(const ChannelSeed& seed, int t) {
  const Int128 first = seed.first.raw(), second = seed.second.raw();
  return first + t * (second - first) +
         static_cast<Int128>(seed.curvature.raw()) * (static_cast<int64_t>(t) * (t - 1) / 2);
}

class QuadSurfaceFlow : public testing::TestWithParam<Flow> {};

TEST_P(QuadSurfaceFlow, RtlMatchesModel) {
  ExpectSameCodes<QuadSurface, Dut>(PatternOf(GetParam(), 1), kSpans, 2);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, QuadSurfaceFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(QuadSurface, ContractMatchesRtl) {
  ExpectTiming<Dut>(QuadSurface::kContract, Curve(17 * kOneCode, 18 * kOneCode, 0),
                    Curve(200 * kOneCode, 0, kOneCode));
}

TEST(QuadSurface, ModelMatchesClosedForm) {
  std::mt19937 random(1);
  for (int span = 0; span < 3000; ++span) {
    const int length = RandomLength(random);
    const ChannelSeed seed = RandomSeed(length, random);
    QuadSurface model(seed);
    for (int t = 0; t < length; ++t, model.Step()) {
      ASSERT_EQ(model.code(), CodeOf(ClosedForm(seed, t))) << "span " << span << " pixel " << t;
    }
  }
}

// A real curve I(t) = A t^2 + D t + F, and the seed that quantises A, I(0) and I(1). F and with it
// I(0), I(1) contain the half code that makes truncation round.
struct RealCurve {
  double a, d, f;

  static RealCurve Through(double first, double second, double a) {
    return {a, second - first - a, first};
  }
  long double At(int t) const { return (static_cast<long double>(a) * t + d) * t + f; }
  ChannelSeed Seed() const {
    return {IntensityAcc::Round(static_cast<double>(At(0))),
            IntensityAcc::Round(static_cast<double>(At(1))),
            {},
            IntensityAcc::FromRaw(2 * IntensityAcc::Round(a).raw())};
  }
};

// |accumulator - I(t)| in codes.
double Drift(const ChannelSeed& seed, const RealCurve& curve, int t) {
  const long double real = std::ldexp(curve.At(t), 26);
  return static_cast<double>(
      std::ldexp(std::abs(static_cast<long double>(ClosedForm(seed, t)) - real), -26));
}

double Bound(int t) {
  const int64_t square = static_cast<int64_t>(t) * t;
  return t == 0 ? std::ldexp(1, -27) : std::ldexp(static_cast<double>(square + t - 1), -27);
}

// Six intensities in 0..255 span a surface in -85..340. Ends and middle of the curve lie there, a
// quarter of them at its limits.
RealCurve RandomCurve(std::mt19937& random) {
  std::uniform_real_distribution<double> level(-85, 340);
  const auto pick = [&] {
    const double inside = level(random);
    return 0.5 + (random() % 4 ? inside : inside < 127.5 ? -85 : 340);
  };
  const double end_t = kBoundedLength - 1;
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

TEST(QuadSurface, ModelWithinErrorBound) {
  std::mt19937 random(1);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const RealCurve curve = RandomCurve(random);
    const ChannelSeed seed = curve.Seed();
    QuadSurface model(seed);
    for (int t = 0; t < kBoundedLength; ++t, model.Step()) {
      const double drift = Drift(seed, curve, t);
      ASSERT_LE(drift, Bound(t)) << "curve " << i << " pixel " << t;
      ASSERT_EQ(model.code(), CodeOf(ClosedForm(seed, t)));
      const double ideal = std::clamp(static_cast<double>(curve.At(t)) - 0.5, 0.0, 255.0);
      ASSERT_LE(std::abs(model.code() - ideal), 0.5 + drift + 1e-9);
      worst = std::max(worst, drift);
    }
  }
  for (int i = 0; i < 300000; ++i) {
    const RealCurve curve = RandomCurve(random);
    worst = std::max(worst, Drift(curve.Seed(), curve, kBoundedLength - 1));
  }
  RecordProperty("worst_error_microcodes", static_cast<int>(worst * 1e6));
  RecordProperty("worst_permille_of_bound",
                 static_cast<int>(1000 * worst / Bound(kBoundedLength - 1)));
  EXPECT_LE(Bound(kBoundedLength - 1), QuadSurface::kContract.max_error_ulp);
  EXPECT_LE(worst, Bound(kBoundedLength - 1));
  EXPECT_GT(worst, 0.999 * Bound(kBoundedLength - 1)) << "the search is blind";
}

// A, I(0) and I(1) lie half an ulp, less a 65536th, from their seeds, with the signs that add up.
TEST(QuadSurface, RoundingErrorsAtTheirExtremesStayInBound) {
  const double half_ulp = std::ldexp(0.5 - std::ldexp(1, -16), -26);
  for (const double sign : {1.0, -1.0}) {
    const RealCurve curve = RealCurve::Through(10 - sign * half_ulp, 10.125 + sign * half_ulp,
                                               std::ldexp(1, -16) + sign * half_ulp);
    const ChannelSeed seed = curve.Seed();
    for (int t = 1; t < kMaxScreen; ++t) {
      ASSERT_LE(Drift(seed, curve, t), Bound(t));
      ASSERT_GT(Drift(seed, curve, t), 0.999 * Bound(t)) << "pixel " << t;
    }
    EXPECT_LE(Drift(seed, curve, kBoundedLength - 1), QuadSurface::kContract.max_error_ulp);
  }
}

// Codes of RTL and model along a span, which must agree.
std::vector<int> Codes(Dut* rtl, const ChannelSeed& seed, int length) {
  QuadSurface model(seed);
  rtl->Cycle(true, false, seed);
  std::vector<int> codes;
  for (int t = 0; t < length; ++t) {
    EXPECT_EQ(rtl->code(), model.code());
    codes.push_back(rtl->code());
    if (t + 1 == length) break;
    rtl->Cycle(false, true, seed);
    model.Step();
  }
  return codes;
}

TEST(QuadSurface, ClampsOnBothSides) {
  Dut rtl;
  // -1, 0, 3, 8: and 256, 255, 252.
  EXPECT_EQ(Codes(&rtl, Curve(-kOneCode, 0, 2 * kOneCode), 4), (std::vector<int>{0, 0, 3, 8}));
  EXPECT_EQ(Codes(&rtl, Curve(256 * kOneCode, 255 * kOneCode, -2 * kOneCode), 3),
            (std::vector<int>{255, 255, 252}));
  // -85 up to 340 and down again: both clamps in one span.
  EXPECT_EQ(Codes(&rtl, Curve(-85 * kOneCode, 340 * kOneCode, -850 * kOneCode / 2), 2),
            (std::vector<int>{0, 255}));
}

TEST(QuadSurface, HighlightHasAMaximumInsideTheSpan) {
  Dut rtl;
  // 255 - (t - 3)^2.
  EXPECT_EQ(Codes(&rtl, Curve(246 * kOneCode, 251 * kOneCode, -2 * kOneCode), 7),
            (std::vector<int>{246, 251, 254, 255, 254, 251, 246}));
}

TEST(QuadSurface, LastPixelOfLongestSpan) {
  Dut rtl;
  // t^2 / 65536 codes: 255.875 at t = 4095.
  const int64_t a = kOneCode >> 16;
  const std::vector<int> codes = Codes(&rtl, Curve(0, a, 2 * a), kMaxScreen);
  EXPECT_EQ(codes.back(), 255);
  EXPECT_EQ(codes[4087], 254);  // 254.88
  EXPECT_EQ(codes[4088], 255);  // 255.0
}

TEST(QuadSurface, SinglePixelRunsBackToBack) {
  Dut rtl;
  for (int code = 0; code <= 255; ++code) {
    EXPECT_EQ(Codes(&rtl, Curve(code * kOneCode, kMostAcc, kLeastAcc), 1), std::vector<int>{code});
  }
}

TEST(QuadSurface, WrapIsNeverShown) {
  Dut rtl;
  // 0, 300, 600, ...: the look-ahead wraps while the second pixel, the last one, is shown.
  EXPECT_EQ(Codes(&rtl, Curve(0, 300 * kOneCode, 0), 2), (std::vector<int>{0, 255}));
  EXPECT_EQ(Codes(&rtl, Curve(7 * kOneCode, 8 * kOneCode, 0), 3), (std::vector<int>{7, 8, 9}));
}

TEST(QuadSurface, LoadWinsOverStepAndIdleHolds) {
  Dut rtl;
  const ChannelSeed noise = Curve(99 * kOneCode, 98 * kOneCode, 97 * kOneCode);
  rtl.Cycle(true, true, Curve(10 * kOneCode, 15 * kOneCode, 2 * kOneCode));
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, false, noise);
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, true, noise);
  EXPECT_EQ(rtl.code(), 15);
  rtl.Cycle(false, true, noise);
  EXPECT_EQ(rtl.code(), 22);
  rtl.Cycle(true, true, Curve(20 * kOneCode, 0, 0));
  EXPECT_EQ(rtl.code(), 20);
}

}  // namespace
}  // namespace shading
