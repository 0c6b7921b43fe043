// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_segment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tb/dut/quad_segment_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/intensity/real_curve.h"

namespace shading {
namespace {

constexpr int kSpans = 5000;
constexpr int kUnits = IntensityAcc::kFraction - Tolerance::kFraction;
using Dut = tb::QuadSegmentDut;

// Exact as long as the unit draws no line over several pixels.
class ExactDut : public Dut {
 public:
  void Cycle(bool load, bool step, const ChannelSeed& seed) { Dut::Cycle(load, step, seed, {}); }
};

// Seed of the integer curve first + t d + t (t - 1) / 2 2A; 2A and the values may wrap.
ChannelSeed Bent(int64_t first, int64_t difference, Int128 curvature) {
  const Int128 turn = Int128{1} << IntensityAcc::kWidth;
  const auto wrapped = static_cast<int64_t>(curvature - turn * FloorDivide(curvature, turn));
  return {IntensityAcc::Wrap(first), IntensityAcc::Wrap(first + difference),
          IntensityAcc::Wrap(difference), IntensityAcc::Wrap(wrapped)};
}

// Distance of the shown value from the curve, modulo the register; in 2^-26 codes.
int64_t FillError(const QuadSegment& model, const ChannelSeed& seed, int t) {
  const auto distance = static_cast<int64_t>(model.value().raw() - CurveAt(seed, t));
  return IntensityAcc::Wrap(distance).raw();
}

// Codes by which the roundings of I(0), I(1) - I(0) and A move pixel t at most.
double Bound(int t) { return std::ldexp(static_cast<double>(t) * t + 1, -27); }

Tolerance RandomTolerance(std::mt19937& random) {
  switch (random() % 4) {
    case 0: return Tolerance::FromRaw(0);
    case 1: return Tolerance::FromRaw(Tolerance::kMaxRaw);
    default: return Tolerance::FromRaw((random() & Tolerance::kMaxRaw) >> (random() % 16));
  }
}

// One of two: a curvature at the limit of some k, or one to three units beside it.
void BringToLimit(Tolerance tolerance, std::mt19937& random, ChannelSeed* seed) {
  if (random() % 2) return;
  const int k = static_cast<int>(random() % (QuadSegment::kMostShift + 1));
  const int64_t limit = tolerance.raw() << (kUnits + 3) >> (2 * k);
  const int64_t magnitude = limit - 3 + static_cast<int64_t>(random() % 7);
  seed->curvature = IntensityAcc::Wrap(random() % 2 ? magnitude : -magnitude);
}

class QuadSegmentFlow : public testing::TestWithParam<Flow> {};

TEST_P(QuadSegmentFlow, RtlMatchesModel) {
  std::mt19937 random(2);
  const FlowPattern steps = PatternOf(GetParam(), 1);
  Dut rtl;
  int64_t cycle = 0;
  std::array<int, QuadSegment::kMostShift + 1> seen = {};
  for (int span = 0; span < kSpans; ++span) {
    const int length = RandomLength(random);
    const Tolerance tolerance = RandomTolerance(random);
    ChannelSeed seed = RandomSeed(length, random);
    BringToLimit(tolerance, random, &seed);
    QuadSegment model(seed, tolerance);
    ++seen[static_cast<size_t>(model.shift())];
    rtl.Cycle(true, random() % 2, seed, tolerance);
    for (int t = 0; t < length; ++cycle) {
      ASSERT_EQ(rtl.code(), model.code()) << "span " << span << " pixel " << t;
      const bool step = steps.At(cycle);
      const ChannelSeed noise = {RandomAcc(random), {}, RandomAcc(random), RandomAcc(random)};
      rtl.Cycle(false, step, noise, RandomTolerance(random));
      if (step) model.Step();
      t += step;
    }
  }
  for (const int count : seen) EXPECT_GT(count, 50) << "every length of segment is seen";
}

INSTANTIATE_TEST_SUITE_P(AllFlows, QuadSegmentFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(QuadSegment, ContractMatchesRtl) {
  ExpectTiming<ExactDut>(QuadSegment::kContract, Bent(17 * kOneCode, kOneCode, 0),
                         Bent(200 * kOneCode, 0, 2 * kOneCode));
}

TEST(QuadSegment, SegmentsAreTheLongestWithinTheTolerance) {
  std::mt19937 random(3);
  for (int i = 0; i < 300000; ++i) {
    const Tolerance tolerance = RandomTolerance(random);
    ChannelSeed seed = RandomSeed(64, random);
    BringToLimit(tolerance, random, &seed);
    const int k = QuadSegment(seed, tolerance).shift();
    const Int128 magnitude = std::abs(seed.curvature.raw());
    const Int128 limit = static_cast<Int128>(tolerance.raw()) << (kUnits + 3);
    ASSERT_TRUE(k == 0 || magnitude << (2 * k) <= limit);
    ASSERT_TRUE(k == QuadSegment::kMostShift || magnitude << (2 * k + 2) > limit);
  }
}

// Longer lines would leave the tolerance; the worst of those that are drawn fill it.
TEST(QuadSegment, LinesStayWithinTheTolerance) {
  std::mt19937 random(4);
  std::array<double, QuadSegment::kMostShift + 1> worst = {};
  for (int i = 0; i < 4000; ++i) {
    const auto tolerance = Tolerance::FromRaw(1 + random() % Tolerance::kMaxRaw);
    const int64_t most = tolerance.raw() << kUnits;
    ChannelSeed seed = RandomSeed(kBoundedLength, random);
    BringToLimit(tolerance, random, &seed);
    seed.curvature = IntensityAcc::Wrap(seed.curvature.raw() & ~int64_t{1});
    QuadSegment model(seed, tolerance);
    const int length = std::min(kMaxScreen, 3 << model.shift());
    for (int t = 0; t < length; ++t, model.Step()) {
      const int64_t error = FillError(model, seed, t);
      ASSERT_LE(std::abs(error), most) << "curve " << i << " pixel " << t;
      if (t % (1 << model.shift()) == 0) {
        ASSERT_EQ(error, 0) << "curve " << i << " pixel " << t;
      }
      double& found = worst[static_cast<size_t>(model.shift())];
      found = std::max(found, static_cast<double>(std::abs(error)) / static_cast<double>(most));
    }
  }
  EXPECT_EQ(worst[0], 0) << "one pixel a segment is the curve";
  for (size_t k = 1; k < worst.size(); ++k) EXPECT_GT(worst[k], 0.9) << "k = " << k;
}

// |A| 4^k / 4 = tolerance.
TEST(QuadSegment, ToleranceIsAttainedInTheMiddleOfASegment) {
  for (int k = 1; k <= QuadSegment::kMostShift; ++k) {
    const auto tolerance = Tolerance::FromRaw(1 << (k > 7 ? 2 * k - 14 : 0));
    const int64_t a = (tolerance.raw() << (kUnits + 2)) >> (2 * k);
    for (const int64_t sign : {1, -1}) {
      const ChannelSeed seed = Bent(100 * kOneCode, -3 * a, sign * 2 * a);
      QuadSegment model(seed, tolerance);
      ASSERT_EQ(model.shift(), k);
      for (int t = 0; t < 1 << (k - 1); ++t) model.Step();
      EXPECT_EQ(FillError(model, seed, 1 << (k - 1)), sign * (tolerance.raw() << kUnits));
    }
  }
}

TEST(QuadSegment, ToleranceZeroIsTheCurve) {
  std::mt19937 random(5);
  for (int span = 0; span < 3000; ++span) {
    const int length = RandomLength(random);
    ChannelSeed seed = RandomSeed(length, random);
    seed.second = IntensityAcc::Wrap(seed.first.raw() + seed.difference.raw());
    QuadSegment model(seed, {});
    for (int t = 0; t < length; ++t, model.Step()) {
      ASSERT_EQ(model.code(), CodeOf(CurveAt(seed, t))) << "span " << span << " pixel " << t;
    }
  }
}

// Beyond the tolerance: rounding of the seeds. Curves with a rounding error of half a unit in each
// seed, and the line's error of the same sign.
TEST(QuadSegment, ModelWithinErrorBound) {
  constexpr int kShift = 4;
  const double half_unit = std::ldexp(0.5 - std::ldexp(1, -16), -26);
  std::mt19937 random(6);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const auto tolerance = Tolerance::FromRaw(1 + random() % 16);
    const double sign = random() % 2 ? 1 : -1;
    const double a = sign * std::ldexp(static_cast<double>(tolerance.raw()), 2 - 12 - 2 * kShift);
    const double first = 100 + static_cast<double>(random() % 100);
    const auto off = [&](double direction) { return random() % 8 ? direction * half_unit : 0; };
    const double at_0 = first - off(sign), difference = -a - off(sign);
    const RealCurve curve = RealCurve::Through(at_0, at_0 + difference, a - off(sign));
    const ChannelSeed seed = curve.SeedOfDifferenceAndA();
    QuadSegment model(seed, tolerance);
    ASSERT_EQ(model.shift(), kShift);
    for (int t = 0; t < kBoundedLength; ++t, model.Step()) {
      const int64_t fill = FillError(model, seed, t);
      const auto shown = static_cast<long double>(CurveAt(seed, t) + fill);
      const auto error = static_cast<double>(std::abs(std::ldexp(shown, -26) - curve.At(t)));
      ASSERT_LE(error, tolerance.ToReal() + Bound(t)) << "curve " << i << " pixel " << t;
      worst = std::max(worst, error - tolerance.ToReal());
    }
  }
  RecordProperty("worst_beyond_tolerance_microcodes", static_cast<int>(worst * 1e6));
  EXPECT_LE(Bound(kBoundedLength - 1), QuadSegment::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.99 * Bound(kBoundedLength - 1)) << "the search is blind";
}

// A sliver's 2A = 1024 m + little reads as little: its two shown pixels are within the tolerance.
TEST(QuadSegment, WrappedCurvatureOfASliver) {
  const auto tolerance = Tolerance::FromRaw(1 << 12);
  const Int128 turn = Int128{1} << IntensityAcc::kWidth;
  Dut rtl;
  for (const int m : {-5, -1, 1, 3}) {
    for (const int64_t little : {int64_t{0}, kOneCode / 64, -kOneCode / 64}) {
      const ChannelSeed seed = Bent(40 * kOneCode, 160 * kOneCode, m * turn + little);
      QuadSegment model(seed, tolerance);
      EXPECT_GT(model.shift(), 0);
      rtl.Cycle(true, false, seed, tolerance);
      EXPECT_EQ(rtl.code(), 40);
      rtl.Cycle(false, true, seed, tolerance);
      model.Step();
      EXPECT_EQ(rtl.code(), model.code());
      EXPECT_NEAR(rtl.code(), 200, 1);
    }
  }
}

TEST(QuadSegment, LineOfALinearSpanIsExact) {
  Dut rtl;
  const ChannelSeed seed = Bent(-kOneCode, kOneCode / 16, 0);
  rtl.Cycle(true, false, seed, {});
  for (int t = 0; t < kMaxScreen; ++t) {
    ASSERT_EQ(rtl.code(), std::clamp(t / 16 - 1, 0, 255)) << "pixel " << t;
    rtl.Cycle(false, true, seed, {});
  }
}

TEST(QuadSegment, LoadWinsOverStepAndIdleHolds) {
  Dut rtl;
  // t (t + 3) / 2 codes from 10 on, in segments of 2 pixels: 10, 12.5, 15, 19.5, 24, 30.5.
  const ChannelSeed seed = Bent(10 * kOneCode, 2 * kOneCode, kOneCode);
  const auto half_code = Tolerance::FromRaw(1 << 11);
  for (int load = 0; load < 2; ++load) {
    rtl.Cycle(true, true, seed, half_code);
    EXPECT_EQ(rtl.code(), 10);
    rtl.Cycle(false, false, {}, {});
    EXPECT_EQ(rtl.code(), 10);
    for (const int code : {12, 15, 19, 24, 30}) {
      rtl.Cycle(false, true, {}, {});
      EXPECT_EQ(rtl.code(), code);
    }
  }
}

}  // namespace
}  // namespace shading
