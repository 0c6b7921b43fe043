// SPDX-License-Identifier: Apache-2.0
#include "model/raster/pixel_walker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <random>
#include <tuple>
#include <vector>

#include "tb/dut/pixel_walker_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/raster/walked_pixels.h"

namespace shading {
namespace {

constexpr int kRuns = 3000;
using Dut = tb::PixelWalkerDut;
using Dut4 = tb::PixelWalker4Dut;

using Flows = std::tuple<Flow, Flow>;
class PixelWalkerFlow : public testing::TestWithParam<Flows> {};

TEST_P(PixelWalkerFlow, RtlMatchesModel) {
  ExpectWalk<Dut>(RandomRuns(kRuns, 3), PatternOf(std::get<0>(GetParam()), 1),
                  PatternOf(std::get<1>(GetParam()), 2));
}

TEST_P(PixelWalkerFlow, FourLanesMatchModel) {
  ExpectWalk<Dut4>(RandomRuns(kRuns, 4), PatternOf(std::get<0>(GetParam()), 1),
                   PatternOf(std::get<1>(GetParam()), 2));
}

constexpr auto kFlows = {Flow::kAlways, Flow::kOneInFour, Flow::kRandom};
INSTANTIATE_TEST_SUITE_P(AllFlows, PixelWalkerFlow,
                         testing::Combine(testing::ValuesIn(kFlows), testing::ValuesIn(kFlows)),
                         [](const auto& flow) {
                           return "Source" + NameOf(std::get<0>(flow.param)) + "Sink" +
                                  NameOf(std::get<1>(flow.param));
                         });

template <typename Build>
void ExpectTiming() {
  constexpr UnitContract kContract = PixelWalker::kContract;
  EXPECT_EQ(Build::kLatency, kContract.latency_cycles);
  const FlowPattern always = FlowPattern::Always();
  Build rtl;
  const std::vector<SpanSeed> single(16, RunOf(1, 2, 1, 0, 0));
  const auto result = rtl.Run(single, always, always);
  ASSERT_EQ(result.failure, "");
  for (size_t run = 0; run < single.size(); ++run) {
    EXPECT_EQ(result.groups[run].cycle - result.taken[run], kContract.latency_cycles);
    if (run == 0) continue;
    EXPECT_EQ(result.taken[run] - result.taken[run - 1], kContract.interval_cycles);
  }
  const auto whole_line = rtl.Run({RunOf(0, 0, kMaxScreen, 0, 1)}, always, always);
  ASSERT_EQ(whole_line.failure, "");
  EXPECT_EQ(whole_line.groups.back().cycle,
            kContract.latency_cycles + kMaxScreen / Build::kLaneCount - 1);
}

TEST(PixelWalker, ContractMatchesRtl) {
  ExpectTiming<Dut>();
  ExpectTiming<Dut4>();
}

// Every length modulo the lanes, up to three groups, one after the other without a bubble.
TEST(PixelWalker, FourLanesMaskTheTail) {
  std::vector<SpanSeed> runs;
  for (int length = 1; length <= 12; ++length) {
    runs.push_back(RunOf(4095 - length, length, length, kUlp * length, 3 * kUlp + 1));
  }
  const FlowPattern always = FlowPattern::Always();
  Dut4 rtl;
  const auto result = rtl.Run(runs, always, always);
  ASSERT_NO_FATAL_FAILURE(ExpectPixels(runs, result));
  const std::vector<uint32_t> tails = {1, 3, 7, 15};
  size_t group = 0;
  for (int length = 1; length <= 12; ++length) {
    for (int left = length; left > 4; left -= 4) EXPECT_EQ(result.groups[group++].mask, 15);
    EXPECT_EQ(result.groups[group++].mask, tails[static_cast<size_t>(length - 1) % 4]);
  }
  EXPECT_EQ(result.groups.back().cycle - result.groups.front().cycle + 1,
            static_cast<int64_t>(group));
}

TEST(PixelWalker, ModelMatchesClosedForm) {
  for (const SpanSeed& run : RandomRuns(20000, 1)) {
    PixelWalker model(run);
    for (int i = 0; i < run.length; ++i, model.Step()) {
      ASSERT_EQ(model.z(), DepthOf(ClosedForm(run, i))) << "pixel " << i;
      ASSERT_EQ(model.x(), run.x + i);
      ASSERT_EQ(model.y(), run.y);
    }
  }
}

// |accumulator - (z + i dz/dx + half an ulp)| in ulp of U0.24.
double Drift(const SpanSeed& run, double z, double dz_dx, int i) {
  const long double real =
      std::ldexp(z + static_cast<long double>(dz_dx) * i, DepthAcc::kFraction) + kUlp / 2;
  return static_cast<double>(std::abs(static_cast<long double>(ClosedForm(run, i)) - real) / kUlp);
}

SpanSeed Quantised(double z, double dz_dx) {
  return RunOf(0, 0, kMaxScreen, std::llround(std::ldexp(z, DepthAcc::kFraction)) + kUlp / 2,
               DepthAcc::Round(dz_dx).raw());
}

TEST(PixelWalker, ModelWithinErrorBound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> depth(0, 1);
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const double z = depth(random), dz_dx = (depth(random) - z) / (kMaxScreen - 1);
    const SpanSeed run = Quantised(z, dz_dx);
    PixelWalker model(run);
    for (int t = 0; t < kMaxScreen; ++t, model.Step()) {
      const double drift = Drift(run, z, dz_dx, t);
      ASSERT_LE(drift, std::ldexp(t + 1, -15));
      ASSERT_EQ(model.z(), DepthOf(ClosedForm(run, t)));
      ASSERT_LE(std::abs(model.z() - std::ldexp(z + dz_dx * t, 24)), 0.5 + drift + 1e-6);
      worst = std::max(worst, drift);
    }
  }
  RecordProperty("worst_error_microulp", static_cast<int>(worst * 1e6));
  EXPECT_LE(worst, PixelWalker::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.99 * PixelWalker::kContract.max_error_ulp) << "the search is blind";
}

// Both numbers lie half an ulp of S1.38, less a 4096th, below the next one.
TEST(PixelWalker, RoundingErrorsAtTheirExtremesStayInBound) {
  const double half_ulp = std::ldexp(0.5 - std::ldexp(1, -12), -38);
  const double z = 0.25 + half_ulp, dz_dx = std::ldexp(1, -13) + half_ulp;
  const double drift = Drift(Quantised(z, dz_dx), z, dz_dx, kMaxScreen - 1);
  EXPECT_LE(drift, PixelWalker::kContract.max_error_ulp);
  EXPECT_GT(drift, 0.999 * PixelWalker::kContract.max_error_ulp);
}

// Depths of RTL and model along one run, which must agree, with one lane and with four.
std::vector<uint32_t> Depths(const SpanSeed& run) {
  const FlowPattern always = FlowPattern::Always();
  ExpectPixels({run}, Dut4().Run({run}, always, always));
  const Dut::Result result = Dut().Run({run}, always, always);
  ExpectPixels({run}, result);
  std::vector<uint32_t> depths;
  for (const Dut::Group& group : result.groups) depths.push_back(group.lane[0].z);
  return depths;
}

TEST(PixelWalker, ClampsOnBothSides) {
  constexpr uint32_t kFar = Depth::kMaxRaw;
  EXPECT_EQ(Depths(RunOf(0, 0, 4, -kUlp - 1, kUlp)), (std::vector<uint32_t>{0, 0, 0, 1}));
  EXPECT_EQ(Depths(RunOf(0, 0, 4, kOneDepth - 2 * kUlp, kUlp)),
            (std::vector<uint32_t>{kFar - 1, kFar, kFar, kFar}));
  EXPECT_EQ(Depths(RunOf(0, 0, 3, kOneDepth + kUlp, -kUlp)),
            (std::vector<uint32_t>{kFar, kFar, kFar}));
}

TEST(PixelWalker, WrapIsNeverShown) {
  // The depth after the second pixel would be 2.7, which S1.38 does not hold.
  const int64_t step = 9 * kOneDepth / 10;
  EXPECT_EQ(Depths(RunOf(0, 0, 2, step, step)),
            (std::vector<uint32_t>{static_cast<uint32_t>(step / kUlp), Depth::kMaxRaw}));
}

TEST(PixelWalker, LastColumnOfTheScreen) {
  const SpanSeed whole = RunOf(0, 4095, kMaxScreen, 0, kUlp), one = RunOf(4095, 0, 1, 0, kUlp);
  const std::vector<SpanSeed> runs = {whole, one, one};
  const auto result = Dut().Run(runs, FlowPattern::Always(), FlowPattern::OneInFour());
  ASSERT_NO_FATAL_FAILURE(ExpectPixels(runs, result));
  EXPECT_EQ(result.groups[4095].lane[0].x, 4095);
  EXPECT_TRUE(result.groups[4095].lane[0].last);
  const auto wide = Dut4().Run(runs, FlowPattern::Always(), FlowPattern::OneInFour());
  ASSERT_NO_FATAL_FAILURE(ExpectPixels(runs, wide));
  EXPECT_EQ(wide.groups[1023].lane[3].x, 4095);
  EXPECT_TRUE(wide.groups[1023].lane[3].last);
  EXPECT_EQ(wide.groups[1024].mask, 1);
}

template <typename Build>
void ExpectResetDropsTheRun() {
  const FlowPattern always = FlowPattern::Always();
  Build rtl;
  EXPECT_NE(rtl.Run({RunOf(5, 6, 33, 0, 1)}, always, always, 4).failure, "");
  rtl.Reset();
  const std::vector<SpanSeed> runs = {RunOf(7, 8, 2, kUlp, kUlp)};
  ExpectPixels(runs, rtl.Run(runs, always, always));
}

TEST(PixelWalker, ResetDropsTheRun) {
  ExpectResetDropsTheRun<Dut>();
  ExpectResetDropsTheRun<Dut4>();
}

TEST(PixelWalkerDeathTest, RunOfNoPixelsStopsTheSimulation) {
  const FlowPattern always = FlowPattern::Always();
  const std::vector<SpanSeed> empty = {RunOf(0, 0, 0, 0, 0)};
  EXPECT_EXIT(Dut().Run(empty, always, always), testing::KilledBySignal(SIGABRT), "");
  EXPECT_EXIT(Dut4().Run(empty, always, always), testing::KilledBySignal(SIGABRT), "");
}

}  // namespace
}  // namespace shading
