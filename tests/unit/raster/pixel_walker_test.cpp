// SPDX-License-Identifier: Apache-2.0
#include "model/raster/pixel_walker.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <random>
#include <tuple>
#include <vector>

#include "model/fixed/wide_integer.h"
#include "tb/dut/pixel_walker_dut.h"
#include "tests/unit/flows.h"

namespace shading {
namespace {

constexpr int kRuns = 3000;
constexpr int64_t kOneDepth = int64_t{1} << DepthAcc::kFraction;  // z = 1
constexpr int64_t kUlp = kOneDepth >> Depth::kFraction;           // of U0.24
using Dut = tb::PixelWalkerDut;

SpanSeed RunOf(int x, int y, int length, int64_t z, int64_t dz_dx) {
  SpanSeed run;
  run.x = x;
  run.y = y;
  run.length = length;
  run.z = DepthAcc::Wrap(z);
  run.dz_dx = DepthAcc::Wrap(dz_dx);
  return run;
}

// z(i) of a run, without a recurrence and without a register that could wrap.
Int128 ClosedForm(const SpanSeed& run, int i) {
  return run.z.raw() + static_cast<Int128>(run.dz_dx.raw()) * i;
}

// Truncates and clamps a depth that was formed without a register, after its wrap.
uint32_t DepthOf(Int128 accumulator) {
  const int64_t z = DepthAcc::Wrap(static_cast<int64_t>(accumulator)).raw();
  const int64_t whole = FloorDivide(z, kUlp);
  return static_cast<uint32_t>(std::clamp<int64_t>(whole, 0, Depth::kMaxRaw));
}

// Short and longest runs, whole-screen offsets, depths of any magnitude: the extremes wrap.
SpanSeed RandomRun(std::mt19937& random) {
  const auto acc = [&] {
    const int64_t bits = static_cast<int64_t>(static_cast<uint64_t>(random()) << 32 | random());
    return bits >> (24 + random() % 40);
  };
  const int kind = static_cast<int>(random() % 32);
  const int any = 1 + static_cast<int>(random() % 64);
  const int length = kind == 0 ? kMaxScreen : kind < 12 ? 1 + kind % 3 : any;
  const int x = static_cast<int>(random() % static_cast<uint32_t>(kMaxScreen - length + 1));
  return RunOf(x, static_cast<int>(random() % kMaxScreen), length, acc(), acc());
}

std::vector<SpanSeed> RandomRuns(int count, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<SpanSeed> runs;
  for (int i = 0; i < count; ++i) runs.push_back(RandomRun(random));
  return runs;
}

void ExpectPixels(const std::vector<SpanSeed>& runs, const Dut::Result& result) {
  ASSERT_EQ(result.failure, "");
  auto pixel = result.pixels.begin();
  for (const SpanSeed& run : runs) {
    PixelWalker model(run);
    for (int i = 0; i < run.length; ++i, ++pixel, model.Step()) {
      ASSERT_NE(pixel, result.pixels.end());
      ASSERT_EQ(pixel->x, model.x()) << "pixel " << i << " of " << run.length;
      ASSERT_EQ(pixel->y, model.y());
      ASSERT_EQ(pixel->z, model.z()) << "pixel " << i << " of " << run.length;
      ASSERT_EQ(pixel->last, i + 1 == run.length);
      ASSERT_EQ(pixel->step, !pixel->last) << "the intensity units lose the walker";
    }
  }
  EXPECT_EQ(pixel, result.pixels.end()) << "more pixels than ordered";
  EXPECT_EQ(result.loads, result.taken);
  EXPECT_EQ(result.stray_steps, 0);
}

// A run is taken as soon as it is on offer and the last pixel of the run before leaves; its pixels
// leave one per willing cycle of the sink, from the next cycle on.
void ExpectCycles(const std::vector<SpanSeed>& runs, const FlowPattern& source,
                  const FlowPattern& sink, const Dut::Result& result) {
  int64_t taken = -1, last_left = 0, offers = 0;
  size_t index = 0;
  for (size_t run = 0; run < runs.size(); ++run) {
    taken = std::max(source.Next(taken + 1), last_left);
    ASSERT_EQ(result.taken[run], taken) << "run " << run;
    int64_t cycle = taken;
    for (int i = 0; i < runs[run].length; ++i) {
      cycle = sink.Next(cycle + 1);
      ASSERT_EQ(result.pixels[index++].cycle, cycle) << "run " << run << " pixel " << i;
    }
    last_left = cycle;
    offers += last_left - taken;
  }
  EXPECT_EQ(static_cast<int64_t>(result.offers.size()), offers) << "valid waits for ready";
}

using Flows = std::tuple<Flow, Flow>;
class PixelWalkerFlow : public testing::TestWithParam<Flows> {};

TEST_P(PixelWalkerFlow, RtlMatchesModel) {
  const FlowPattern source = PatternOf(std::get<0>(GetParam()), 1);
  const FlowPattern sink = PatternOf(std::get<1>(GetParam()), 2);
  const std::vector<SpanSeed> runs = RandomRuns(kRuns, 3);
  Dut rtl;
  const Dut::Result result = rtl.Run(runs, source, sink);
  ExpectPixels(runs, result);
  if (!HasFatalFailure()) ExpectCycles(runs, source, sink, result);
}

constexpr auto kFlows = {Flow::kAlways, Flow::kOneInFour, Flow::kRandom};
INSTANTIATE_TEST_SUITE_P(AllFlows, PixelWalkerFlow,
                         testing::Combine(testing::ValuesIn(kFlows), testing::ValuesIn(kFlows)),
                         [](const auto& flow) {
                           return "Source" + NameOf(std::get<0>(flow.param)) + "Sink" +
                                  NameOf(std::get<1>(flow.param));
                         });

TEST(PixelWalker, ContractMatchesRtl) {
  EXPECT_EQ(Dut::kLatency, PixelWalker::kContract.latency_cycles);
  const FlowPattern always = FlowPattern::Always();
  Dut rtl;
  const std::vector<SpanSeed> single(16, RunOf(1, 2, 1, 0, 0));
  const Dut::Result result = rtl.Run(single, always, always);
  ASSERT_EQ(result.failure, "");
  for (size_t run = 0; run < single.size(); ++run) {
    EXPECT_EQ(result.pixels[run].cycle - result.taken[run], PixelWalker::kContract.latency_cycles);
    if (run == 0) continue;
    EXPECT_EQ(result.taken[run] - result.taken[run - 1], PixelWalker::kContract.interval_cycles);
  }
  const Dut::Result whole_line = rtl.Run({RunOf(0, 0, kMaxScreen, 0, 1)}, always, always);
  ASSERT_EQ(whole_line.failure, "");
  EXPECT_EQ(whole_line.pixels.back().cycle, PixelWalker::kContract.latency_cycles + 4095);
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

// Depths of RTL and model along one run, which must agree.
std::vector<uint32_t> Depths(const SpanSeed& run) {
  Dut rtl;
  const Dut::Result result = rtl.Run({run}, FlowPattern::Always(), FlowPattern::Always());
  ExpectPixels({run}, result);
  std::vector<uint32_t> depths;
  for (const Dut::WalkedPixel& pixel : result.pixels) depths.push_back(pixel.z);
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
  Dut rtl;
  const auto result = rtl.Run({whole, one, one}, FlowPattern::Always(), FlowPattern::OneInFour());
  ExpectPixels({whole, one, one}, result);
  ASSERT_FALSE(HasFatalFailure());
  EXPECT_EQ(result.pixels[4095].x, 4095);
  EXPECT_TRUE(result.pixels[4095].last);
}

TEST(PixelWalker, ResetDropsTheRun) {
  const FlowPattern always = FlowPattern::Always();
  Dut rtl;
  EXPECT_NE(rtl.Run({RunOf(5, 6, 9, 0, 1)}, always, always, 4).failure, "");
  rtl.Reset();
  const std::vector<SpanSeed> runs = {RunOf(7, 8, 2, kUlp, kUlp)};
  ExpectPixels(runs, rtl.Run(runs, always, always));
}

TEST(PixelWalkerDeathTest, RunOfNoPixelsStopsTheSimulation) {
  const FlowPattern always = FlowPattern::Always();
  EXPECT_EXIT(Dut().Run({RunOf(0, 0, 0, 0, 0)}, always, always), testing::KilledBySignal(SIGABRT),
              "");
}

}  // namespace
}  // namespace shading
