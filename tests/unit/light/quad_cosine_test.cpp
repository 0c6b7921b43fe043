// SPDX-License-Identifier: Apache-2.0
#include "model/light/quad_cosine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/fixed/wide_integer.h"
#include "tb/dut/quad_cosine_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {
namespace {

constexpr int kBoundedLength = 2048;  // pixels for which the contract states its error
constexpr int64_t kOne = int64_t{1} << CosineAcc::kFraction;

CosineAcc AnyCosine(std::mt19937& random) {
  const int64_t near = static_cast<int64_t>(random() % 5) - 2;
  return CosineAcc::Wrap(random() % 4 ? AnyOctave(CosineAcc::kWidth, random) : 2 * kOne + near);
}
CurveSeed AnySeed(std::mt19937& random) {
  return {AnyCosine(random), AnyCosine(random), AnyCosine(random), AnyCosine(random)};
}

template <typename Dut, int kAtLane, int kOf>
struct Build {
  using Rtl = Dut;
  static constexpr int kLane = kAtLane, kLanes = kOf;
};
template <typename Build>
class QuadCosineBuild : public testing::Test {};
using Builds = testing::Types<Build<tb::QuadCosineDut, 0, 1>, Build<tb::QuadCosineLane3Dut, 3, 4>>;
TYPED_TEST_SUITE(QuadCosineBuild, Builds, );

// Seeds are loaded at random, also while a step is asked for; the port carries noise otherwise.
TYPED_TEST(QuadCosineBuild, RtlMatchesModel) {
  for (const Flow flow : {Flow::kAlways, Flow::kOneInFour, Flow::kRandom}) {
    std::mt19937 random(1);
    const FlowPattern steps = PatternOf(flow, 2);
    typename TypeParam::Rtl rtl;
    QuadCosine model;
    for (int64_t cycle = 0; cycle < 500000; ++cycle) {
      const CurveSeed seed = AnySeed(random);
      const bool load = cycle == 0 || random() % 64 == 0;
      rtl.Cycle(load, steps.At(cycle), seed);
      if (load) {
        model = QuadCosine(seed, TypeParam::kLane, TypeParam::kLanes);
      } else if (steps.At(cycle)) {
        model.Step();
      }
      ASSERT_EQ(rtl.value(), model.value()) << NameOf(flow) << ", cycle " << cycle;
    }
  }
}

TYPED_TEST(QuadCosineBuild, ContractMatchesRtl) {
  EXPECT_EQ(TypeParam::Rtl::kLatency, QuadCosine::kContract.latency_cycles);
  EXPECT_EQ(QuadCosine::kContract.interval_cycles, 1);
  typename TypeParam::Rtl rtl;
  for (int64_t load = 0; load < 8; ++load) {
    rtl.Cycle(true, true, {CosineAcc::FromRaw(load << 14), {}, {}, {}});
    EXPECT_EQ(rtl.value().raw(), load) << "one cycle later, every cycle";
  }
}

// c(t) of the seed, rounded and saturated, without a register: lanes together show every pixel.
TEST(QuadCosine, LanesMatchClosedForm) {
  std::mt19937 random(2);
  for (const int lanes : {1, 4}) {
    for (int span = 0; span < 500; ++span) {
      const CurveSeed seed = AnySeed(random);
      for (int lane = 0; lane < lanes; ++lane) {
        QuadCosine model(seed, lane, lanes);
        for (int64_t t = lane; t < 512; t += lanes, model.Step()) {
          const Int128 value = seed.first.raw() + static_cast<Int128>(seed.difference.raw()) * t +
                               static_cast<Int128>(seed.curvature.raw()) * (t * (t - 1) / 2);
          const CosineAcc wrapped = CosineAcc::Wrap(static_cast<int64_t>(value));
          const int64_t rounded = (wrapped.raw() + (1 << 13)) >> 14;
          ASSERT_EQ(model.value().raw(), std::min<int64_t>(rounded, (int64_t{1} << 31) - 1));
        }
      }
    }
  }
}

double Bound(int64_t t) {
  const double drift =
      std::ldexp(1 + static_cast<double>(t) + 0.5 * static_cast<double>(t * (t - 1)), -45);
  return std::ldexp(drift, Cosine::kFraction) + 0.5;
}

// |c(t) - real| in ulp of S1.30, for a parabola in -1..1 with its seeds rounded.
double Error(double first, double slope, double bend, int last) {
  const auto round = [](double x) {
    return CosineAcc::FromRaw(std::llround(std::ldexp(x, CosineAcc::kFraction)));
  };
  QuadCosine model({round(first), {}, round(slope), round(bend)});
  for (int t = 0; t < last; ++t) model.Step();
  const long double real = static_cast<long double>(first) +
                           static_cast<long double>(slope) * last +
                           static_cast<long double>(bend) * last * (last - 1) / 2;
  return static_cast<double>(std::abs(static_cast<long double>(model.value().raw()) -
                                      std::ldexp(real, Cosine::kFraction)));
}

TEST(QuadCosine, ModelWithinErrorBound) {
  constexpr int kLast = kBoundedLength - 1;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1, 1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    worst = std::max(worst, Error(0.3 * unit(random), 0.3 * unit(random) / kLast,
                                  0.6 * unit(random) / kLast / kLast, kLast));
  }
  EXPECT_LE(Bound(kLast), QuadCosine::kContract.max_error_ulp);
  EXPECT_LE(worst, Bound(kLast));
  EXPECT_GT(worst, 0.97 * Bound(kLast)) << "the search is blind";
  RecordProperty("worst_permille_of_bound", static_cast<int>(1000 * worst / Bound(kLast)));
}

TEST(QuadCosine, OvershootSaturatesAndComesBack) {
  tb::QuadCosineDut rtl;
  // 2 - 2^-44 is the most that the register holds; rounding up saturates.
  const CurveSeed seed = {CosineAcc::FromRaw(2 * kOne - 1), {}, CosineAcc::FromRaw(-kOne / 2), {}};
  QuadCosine model(seed);
  rtl.Cycle(true, false, seed);
  EXPECT_EQ(rtl.value().raw(), (int64_t{1} << 31) - 1);
  rtl.Cycle(false, true, seed);
  model.Step();
  EXPECT_EQ(rtl.value(), model.value());
  EXPECT_EQ(rtl.value().raw(), int64_t{3} << 29);
}

TEST(QuadCosine, LoadWinsOverStepAndIdleHolds) {
  tb::QuadCosineDut rtl;
  const CurveSeed seed = {CosineAcc::FromRaw(kOne / 2), {}, CosineAcc::FromRaw(kOne / 4), {}};
  rtl.Cycle(true, true, seed);
  EXPECT_EQ(rtl.value().raw(), int64_t{1} << 29);
  rtl.Cycle(false, false, {});
  EXPECT_EQ(rtl.value().raw(), int64_t{1} << 29);
  rtl.Cycle(false, true, {});
  EXPECT_EQ(rtl.value().raw(), int64_t{3} << 28);
  rtl.Cycle(true, true, seed);
  EXPECT_EQ(rtl.value().raw(), int64_t{1} << 29);
}

}  // namespace
}  // namespace shading
