// SPDX-License-Identifier: Apache-2.0
#include "model/normal/length_recurrence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/fixed/wide_integer.h"
#include "tb/dut/length_recurrence_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {
namespace {

using Dut = tb::LengthRecurrenceDut;

constexpr int kBoundedLength = 2048;  // pixels for which the contract states its error
constexpr int64_t kOne = int64_t{1} << LengthSquare::kFraction;

LengthSquare AnyLength(std::mt19937& random) {
  const int64_t near = static_cast<int64_t>(random() % 5) - 2;
  return LengthSquare::Wrap(random() % 4 ? AnyOctave(LengthSquare::kWidth, random)
                                         : 2 * kOne + near);
}

LengthSeed AnySeed(std::mt19937& random) {
  return {AnyLength(random), AnyLength(random), AnyLength(random)};
}

class LengthRecurrenceFlow : public testing::TestWithParam<Flow> {};

// Seeds are loaded at random, also while a step is asked for; the port carries noise otherwise.
TEST_P(LengthRecurrenceFlow, RtlMatchesModel) {
  std::mt19937 random(1);
  const FlowPattern steps = PatternOf(GetParam(), 2);
  Dut rtl;
  LengthRecurrence model(LengthSeed{});
  for (int64_t cycle = 0; cycle < 1000000; ++cycle) {
    const LengthSeed seed = AnySeed(random);
    const bool load = cycle == 0 || random() % 64 == 0;
    rtl.Cycle(load, steps.At(cycle), seed);
    if (load) {
      model = LengthRecurrence(seed);
    } else if (steps.At(cycle)) {
      model.Step();
    }
    ASSERT_EQ(rtl.value(), model.value()) << "cycle " << cycle;
  }
}

INSTANTIATE_TEST_SUITE_P(AllFlows, LengthRecurrenceFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(LengthRecurrence, ContractMatchesRtl) {
  EXPECT_EQ(Dut::kLatency, LengthRecurrence::kContract.latency_cycles);
  Dut rtl;
  for (int64_t load = 0; load < 8; ++load) {
    rtl.Cycle(true, true, {LengthSquare::FromRaw(load), {}, {}});
    EXPECT_EQ(rtl.value().raw(), load) << "one cycle later, every cycle";
  }
  EXPECT_EQ(LengthRecurrence::kContract.interval_cycles, 1);
}

TEST(LengthRecurrence, ModelMatchesClosedForm) {
  std::mt19937 random(2);
  for (int span = 0; span < 1000; ++span) {
    const LengthSeed seed = AnySeed(random);
    LengthRecurrence model(seed);
    for (int64_t t = 0; t < 4096; t += 1, model.Step()) {
      const Int128 value = seed.first.raw() + static_cast<Int128>(seed.difference.raw()) * t +
                           static_cast<Int128>(seed.curvature.raw()) * (t * (t - 1) / 2);
      ASSERT_EQ(model.value(), LengthSquare::Wrap(static_cast<int64_t>(value))) << "t " << t;
    }
  }
}

double Bound(int64_t t) { return 0.5 * static_cast<double>(1 + t + t * (t - 1) / 2); }

// Worst |q(t) - |M(t)|^2| in ulp over a span, M linear between unit ends that enclose an angle with
// the given cosine: |M|^2 = 1 - 2 (1 - cosine) w (1 - w).
double Drift(long double cosine, int last) {
  const long double bend = 4 * (1 - cosine) / (static_cast<long double>(last) * last);
  const long double slope = bend / 2 - 2 * (1 - cosine) / last;
  const auto round = [](long double x) {
    return LengthSquare::FromRaw(std::llround(std::ldexp(x, LengthSquare::kFraction)));
  };
  LengthRecurrence model({round(1), round(slope), round(bend)});
  long double worst = 0;
  for (int t = 0; t <= last; ++t, model.Step()) {
    const long double w = static_cast<long double>(t) / last;
    const long double ideal = std::ldexp(1 - 2 * (1 - cosine) * w * (1 - w), 44);
    worst = std::max(worst, std::abs(static_cast<long double>(model.value().raw()) - ideal));
  }
  return static_cast<double>(worst);
}

TEST(LengthRecurrence, ModelWithinErrorBound) {
  std::mt19937 random(3);
  std::uniform_real_distribution<long double> cosine(-1, 1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    worst = std::max(worst, Drift(cosine(random), kBoundedLength - 1));
  }
  RecordProperty("worst_error_ulp", static_cast<int>(worst));
  EXPECT_EQ(Bound(kBoundedLength - 1), LengthRecurrence::kContract.max_error_ulp);
  EXPECT_LT(worst, Bound(kBoundedLength - 1));
  EXPECT_GT(worst, 0.99 * Bound(kBoundedLength - 1)) << "the search is blind";
}

TEST(LengthRecurrence, OpposedNormalsReachZeroAndComeBack) {
  // (1 - t / 2)^2, t = 0..4.
  LengthRecurrence model({LengthSquare::FromRaw(kOne), LengthSquare::FromRaw(-3 * kOne / 4),
                          LengthSquare::FromRaw(kOne / 2)});
  for (const int64_t quarters : {4, 1, 0, 1, 4}) {
    EXPECT_EQ(model.value().raw(), quarters * kOne / 4);
    model.Step();
  }
}

TEST(LengthRecurrence, WrapsAndComesBack) {
  Dut rtl;
  LengthRecurrence model(
      {LengthSquare::FromRaw(kOne), LengthSquare::FromRaw(kOne), LengthSquare::FromRaw(-kOne)});
  rtl.Cycle(
      true, false,
      {LengthSquare::FromRaw(kOne), LengthSquare::FromRaw(kOne), LengthSquare::FromRaw(-kOne)});
  for (const int64_t ones : {1, -2, -2, 1, -1}) {  // 1, 2, 2, 1, -1
    EXPECT_EQ(model.value().raw(), ones * kOne);
    EXPECT_EQ(rtl.value(), model.value());
    model.Step();
    rtl.Cycle(false, true, {});
  }
}

TEST(LengthRecurrence, LoadWinsOverStepAndIdleHolds) {
  Dut rtl;
  const LengthSeed seed = {LengthSquare::FromRaw(7), LengthSquare::FromRaw(3), {}};
  rtl.Cycle(true, true, seed);
  EXPECT_EQ(rtl.value().raw(), 7);
  rtl.Cycle(false, false, {});
  EXPECT_EQ(rtl.value().raw(), 7);
  rtl.Cycle(false, true, {});
  EXPECT_EQ(rtl.value().raw(), 10);
  rtl.Cycle(true, true, seed);
  EXPECT_EQ(rtl.value().raw(), 7);
}

}  // namespace
}  // namespace shading
