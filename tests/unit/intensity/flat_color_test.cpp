// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/flat_color.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tb/dut/flat_color_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/intensity/seed_stimulus.h"

namespace shading {
namespace {

constexpr int kSpans = 5000;

ChannelSeed Colour(int64_t first) { return SeedOf(first, 0, 0, 0); }

class FlatColorFlow : public testing::TestWithParam<Flow> {};

TEST_P(FlatColorFlow, RtlMatchesModel) {
  ExpectSameCodes<FlatColor, tb::FlatColorDut>(PatternOf(GetParam(), 1), kSpans, 2);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, FlatColorFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(FlatColor, ContractMatchesRtl) {
  ExpectTiming<tb::FlatColorDut>(FlatColor::kContract, Colour(17 * kOneCode),
                                 Colour(200 * kOneCode));
}

TEST(FlatColor, ModelWithinErrorBound) {
  std::mt19937 random(1);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const IntensityAcc first = RandomAcc(random);
    const double ideal = std::clamp(std::floor(first.ToReal()), 0.0, 255.0);
    worst = std::max(worst, std::abs(FlatColor(Colour(first.raw())).code() - ideal));
  }
  EXPECT_EQ(worst, FlatColor::kContract.max_error_ulp);
}

// The seed carries half a code, so that truncation rounds the colour to the nearest code.
TEST(FlatColor, ColourRoundsToNearestCode) {
  for (int code = 0; code <= 255; ++code) {
    EXPECT_EQ(FlatColor(Colour(code * kOneCode)).code(), code);
    EXPECT_EQ(FlatColor(Colour(code * kOneCode + kOneCode - 1)).code(), code);
  }
}

TEST(FlatColor, ClampsOnBothSides) {
  tb::FlatColorDut rtl;
  const auto code = [&](int64_t first) {
    rtl.Cycle(true, false, Colour(first));
    EXPECT_EQ(rtl.code(), FlatColor(Colour(first)).code());
    return int{rtl.code()};
  };
  EXPECT_EQ(code(0), 0);
  EXPECT_EQ(code(-1), 0);
  EXPECT_EQ(code(kLeastAcc), 0);
  EXPECT_EQ(code(255 * kOneCode - 1), 254);
  EXPECT_EQ(code(255 * kOneCode), 255);
  EXPECT_EQ(code(256 * kOneCode - 1), 255);
  EXPECT_EQ(code(256 * kOneCode), 255);
  EXPECT_EQ(code(kMostAcc), 255);
}

TEST(FlatColor, HoldsFor4096Pixels) {
  tb::FlatColorDut rtl;
  FlatColor model(Colour(99 * kOneCode));
  rtl.Cycle(true, false, Colour(99 * kOneCode));
  for (int pixel = 0; pixel < kMaxScreen; ++pixel) {
    ASSERT_EQ(rtl.code(), 99);
    ASSERT_EQ(model.code(), 99);
    rtl.Cycle(false, true, Colour(pixel * kOneCode / 16));
    model.Step();
  }
}

}  // namespace
}  // namespace shading
