// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/footprint_mean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "tb/dut/footprint_mean_dut.h"
#include "tests/unit/flows.h"

namespace shading {
namespace {

using Dut = tb::FootprintMeanDut;
constexpr int kPixels = 200000;

// 0 and 1 often; or all bits.
template <typename Value>
Value RandomFactor(std::mt19937& random) {
  const int64_t one = int64_t{1} << Value::kFraction;
  switch (random() % 4) {
    case 0: return Value::FromRaw(random() % 2 * one);
    case 1: return Value::FromRaw(Value::kMaxRaw);
    default: return Value::FromRaw(static_cast<int64_t>(random()) % (one + 1));
  }
}

FootprintMean::Light RandomLight(std::mt19937& random) {
  return {RandomFactor<Diffuse>(random), RandomFactor<Highlight>(random), random() % 2 == 0,
          random() % 2 == 0};
}

// Samples of pixels, one after the other; now and then a pixel without a live sample.
class Samples {
 public:
  explicit Samples(std::mt19937* random) : random_(*random) {}

  Dut::Input Next() {
    if (left_ == 0) {
      constexpr std::array<int, 4> kCounts = {1, 2, 4, 7};
      left_ = count_ = kCounts[random_() % 4];
      live_ = random_() % 4;  // of 3
    }
    Dut::Input input;
    input.light = RandomLight(random_);
    input.first = left_ == count_;
    input.twice = input.first && count_ == 7;
    input.last = --left_ == 0;
    input.live = static_cast<int>(random_() % 3) < live_;
    return input;
  }
  bool between_pixels() const { return left_ == 0; }

 private:
  std::mt19937& random_;
  int left_ = 0, count_ = 0, live_ = 0;
};

bool Same(const FootprintMean::Light& a, const FootprintMean::Light& b) {
  return a.diffuse == b.diffuse && a.highlight == b.highlight && a.unlit == b.unlit &&
         a.skipped == b.skipped;
}

class FootprintMeanFlow : public testing::TestWithParam<Flow> {};

TEST_P(FootprintMeanFlow, RtlMatchesModel) {
  std::mt19937 random(1), noise(2);
  const FlowPattern flow = PatternOf(GetParam(), 2);
  Samples samples(&random), others(&noise);
  Dut rtl;
  FootprintMean model;
  std::deque<std::pair<int64_t, FootprintMean::Light>> due;
  int64_t cycle = 0;
  for (int got = 0; got < kPixels; ++cycle) {
    ASSERT_LT(cycle, int64_t{100} * kPixels) << "deadline";
    const bool valid = flow.At(cycle);
    const Dut::Input input = valid ? samples.Next() : others.Next();
    rtl.Cycle(valid, input);
    if (valid) {
      if (input.first) model = FootprintMean();
      if (input.live) model.Add(input.light, input.twice ? 2 : 1);
      if (input.last) due.emplace_back(cycle + Dut::kLatency - 1, model.Mean());
    }
    const bool expected = !due.empty() && due.front().first == cycle;
    ASSERT_EQ(rtl.valid(), expected) << "cycle " << cycle;
    if (!expected) continue;
    ASSERT_TRUE(Same(rtl.output(), due.front().second)) << "pixel " << got;
    due.pop_front();
    ++got;
  }
}

INSTANTIATE_TEST_SUITE_P(AllFlows, FootprintMeanFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(FootprintMean, ContractMatchesRtl) {
  EXPECT_EQ(Dut::kLatency, FootprintMean::kContract.latency_cycles);
  EXPECT_EQ(FootprintMean::kContract.interval_cycles, 1);
  Dut rtl;
  const Dut::Input input = {{}, true, true, false, true};
  EXPECT_FALSE(rtl.valid()) << "after reset";
  int cycles = 1;
  for (rtl.Cycle(true, input); !rtl.valid() && cycles < 64; ++cycles) rtl.Cycle(false, input);
  EXPECT_EQ(cycles, Dut::kLatency);
  rtl.Cycle(true, input);
  rtl.Reset();
  for (int i = 0; i < 8; ++i) {
    rtl.Cycle(false, input);
    EXPECT_FALSE(rtl.valid()) << "reset empties the pipeline";
  }
}

// Every sum of every weight: the exact quotient, rounded halves up.
TEST(FootprintMean, ModelWithinErrorBound) {
  double worst = 0;
  for (int count = 1; count <= 8; ++count) {
    for (int64_t value = 0; value <= Diffuse::kMaxRaw; value += 1 + value % 3) {
      FootprintMean mean;
      for (int s = 0; s < count; ++s) {
        const int64_t raw = s == 0 ? value : (value + s * 77777) % (Diffuse::kMaxRaw + 1);
        mean.Add({Diffuse::FromRaw(raw), Highlight::FromRaw(raw >> 1)}, 1);
      }
      int64_t sum = 0;
      for (int s = 0; s < count; ++s) {
        sum += s == 0 ? value : (value + s * 77777) % (Diffuse::kMaxRaw + 1);
      }
      const int64_t expected = (2 * sum + count) / (2 * count);
      ASSERT_EQ(mean.Mean().diffuse.raw(), expected) << count << " of " << sum;
      worst = std::max(worst, std::abs(static_cast<double>(mean.Mean().diffuse.raw()) -
                                       static_cast<double>(sum) / count));
    }
  }
  EXPECT_LE(worst, FootprintMean::kContract.max_error_ulp);
  EXPECT_EQ(worst, 0.5) << "the search is blind";
}

TEST(FootprintMean, EqualSamplesAreTheirMean) {
  std::mt19937 random(4);
  for (int count = 1; count <= 8; ++count) {
    const FootprintMean::Light light = RandomLight(random);
    FootprintMean mean;
    for (int s = 0; s < count; ++s) mean.Add(light, 1);
    EXPECT_TRUE(Same(mean.Mean(), light));
    EXPECT_EQ(mean.count(), count);
  }
  FootprintMean none;
  EXPECT_TRUE(Same(none.Mean(), FootprintMean::Light{}));
}

}  // namespace
}  // namespace shading
