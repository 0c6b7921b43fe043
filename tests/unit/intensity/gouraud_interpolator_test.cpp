// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/gouraud_interpolator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tb/dut/gouraud_interpolator_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/intensity/seed_stimulus.h"

namespace shading {
namespace {

constexpr int kSpans = 5000;
using Dut = tb::GouraudInterpolatorDut;

ChannelSeed Line(int64_t first, int64_t difference) { return SeedOf(first, 0, difference, 0); }

// I(t) of the seed, without a recurrence and without a register that could wrap.
Int128 ClosedForm(const ChannelSeed& seed, int t) {
  return seed.first.raw() + static_cast<Int128>(seed.difference.raw()) * t;
}

class GouraudFlow : public testing::TestWithParam<Flow> {};

TEST_P(GouraudFlow, RtlMatchesModel) {
  ExpectSameCodes<GouraudInterpolator, Dut>(PatternOf(GetParam(), 1), kSpans, 2);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, GouraudFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(GouraudInterpolator, ContractMatchesRtl) {
  ExpectTiming<Dut>(GouraudInterpolator::kContract, Line(17 * kOneCode, kOneCode),
                    Line(200 * kOneCode, -kOneCode));
}

TEST(GouraudInterpolator, ModelMatchesClosedForm) {
  std::mt19937 random(1);
  for (int span = 0; span < 3000; ++span) {
    const int length = RandomLength(random);
    const ChannelSeed seed = RandomSeed(length, random);
    GouraudInterpolator model(seed);
    for (int t = 0; t < length; ++t, model.Step()) {
      ASSERT_EQ(model.code(), CodeOf(ClosedForm(seed, t))) << "span " << span << " pixel " << t;
    }
  }
}

// |accumulator - (F + D t + 1/2)| in codes.
double Drift(const ChannelSeed& seed, double f, double d, int t) {
  const long double real = std::ldexp(f + 0.5L + static_cast<long double>(d) * t, 26);
  return static_cast<double>(
      std::ldexp(std::abs(static_cast<long double>(ClosedForm(seed, t)) - real), -26));
}

TEST(GouraudInterpolator, ModelWithinErrorBound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> level(0, 255);
  double worst = 0;
  for (int span = 0; span < 2000; ++span) {
    const double f = level(random), d = (level(random) - f) / (kMaxScreen - 1);
    const ChannelSeed seed = {IntensityAcc::Round(f + 0.5), {}, IntensityAcc::Round(d), {}};
    GouraudInterpolator model(seed);
    for (int t = 0; t < kMaxScreen; ++t, model.Step()) {
      const double drift = Drift(seed, f, d, t);
      ASSERT_LE(drift, std::ldexp(t + 1, -27));
      ASSERT_EQ(model.code(), CodeOf(ClosedForm(seed, t)));
      ASSERT_LE(std::abs(model.code() - (f + d * t)), 0.5 + drift + 1e-12);
      worst = std::max(worst, drift);
    }
  }
  RecordProperty("worst_error_nanocodes", static_cast<int>(worst * 1e9));
  EXPECT_LE(worst, GouraudInterpolator::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.95 * GouraudInterpolator::kContract.max_error_ulp) << "the search is blind";
}

// Both seeds lie half an ulp, less a 65536th, below the next S9.26 number.
TEST(GouraudInterpolator, RoundingErrorsAtTheirExtremesStayInBound) {
  const double half_ulp = std::ldexp(0.5 - std::ldexp(1, -16), -26);
  const double f = 0.25 + half_ulp, d = std::ldexp(1, -5) + half_ulp;
  const ChannelSeed seed = {IntensityAcc::Round(f + 0.5), {}, IntensityAcc::Round(d), {}};
  const double drift = Drift(seed, f, d, kMaxScreen - 1);
  EXPECT_LE(drift, std::ldexp(kMaxScreen, -27));
  EXPECT_GT(drift, 0.9999 * std::ldexp(kMaxScreen, -27));
  EXPECT_LE(drift, GouraudInterpolator::kContract.max_error_ulp);
}

// Codes of RTL and model along a span, which must agree.
std::vector<int> Codes(Dut* rtl, const ChannelSeed& seed, int length) {
  GouraudInterpolator model(seed);
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

TEST(GouraudInterpolator, ClampsOnBothSides) {
  Dut rtl;
  EXPECT_EQ(Codes(&rtl, Line(-kOneCode - 1, kOneCode), 4), (std::vector<int>{0, 0, 0, 1}));
  EXPECT_EQ(Codes(&rtl, Line(254 * kOneCode, kOneCode), 4), (std::vector<int>{254, 255, 255, 255}));
  EXPECT_EQ(Codes(&rtl, Line(257 * kOneCode, -kOneCode), 4),
            (std::vector<int>{255, 255, 255, 254}));
  EXPECT_EQ(Codes(&rtl, Line(2 * kOneCode - 1, -kOneCode), 4), (std::vector<int>{1, 0, 0, 0}));
}

TEST(GouraudInterpolator, LastPixelOfLongestSpan) {
  Dut rtl;
  // 4095 steps of 1/16 code, the last one reaches 255.9375.
  const std::vector<int> codes = Codes(&rtl, Line(0, kOneCode / 16), kMaxScreen);
  EXPECT_EQ(codes.back(), 255);
  EXPECT_EQ(codes[4079], 254);
  EXPECT_EQ(codes[4080], 255);
}

TEST(GouraudInterpolator, SinglePixelRunsBackToBack) {
  Dut rtl;
  for (int code = 0; code <= 255; ++code) {
    EXPECT_EQ(Codes(&rtl, Line(code * kOneCode, kMostAcc), 1), std::vector<int>{code});
  }
}

TEST(GouraudInterpolator, WrapIsNeverShown) {
  Dut rtl;
  // The value after the second pixel would be 600 codes, which S9.26 does not hold.
  EXPECT_EQ(Codes(&rtl, Line(0, 300 * kOneCode), 2), (std::vector<int>{0, 255}));
  EXPECT_EQ(Codes(&rtl, Line(7 * kOneCode, 0), 2), (std::vector<int>{7, 7}));
}

TEST(GouraudInterpolator, LoadWinsOverStepAndIdleHolds) {
  Dut rtl;
  rtl.Cycle(true, true, Line(10 * kOneCode, 5 * kOneCode));
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, false, Line(99 * kOneCode, 99 * kOneCode));
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, true, Line(99 * kOneCode, 99 * kOneCode));
  EXPECT_EQ(rtl.code(), 15);
  rtl.Cycle(true, true, Line(20 * kOneCode, kOneCode));
  EXPECT_EQ(rtl.code(), 20);
}

}  // namespace
}  // namespace shading
