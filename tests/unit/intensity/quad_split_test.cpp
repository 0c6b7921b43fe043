// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "tb/dut/quad_split_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/intensity/real_curve.h"

namespace shading {
namespace {

using Dut = tb::QuadSplitDut;

struct Seeds {
  ChannelSeed diffuse;
  SplitSeed split;
};

// Accumulators that the sum of two terms and the ambient light cannot leave.
ChannelSeed TermSeed(int length, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto round = [](double codes) {
    return IntensityAcc::Wrap(std::llround(std::ldexp(codes, IntensityAcc::kFraction)));
  };
  const double first = 120 * unit(random), difference = 120 * unit(random) / length;
  return {round(first), {}, round(difference), round(200 * unit(random) / length / length)};
}

Seeds RandomSeeds(int length, std::mt19937& random) {
  const auto ambient = static_cast<int64_t>(random() % 256) * kOneCode + kHalfCode;
  return {TermSeed(length, random), {TermSeed(length, random), IntensityAcc::FromRaw(ambient)}};
}

// Any bits; the ambient light is not negative.
Seeds AnySeeds(std::mt19937& random) {
  const auto term = [&] {
    return ChannelSeed{RandomAcc(random), {}, RandomAcc(random), RandomAcc(random)};
  };
  const int64_t ambient = RandomAcc(random).raw() & kMostAcc;
  const ChannelSeed diffuse = term(), specular = term();
  return {diffuse, {specular, IntensityAcc::FromRaw(ambient)}};
}

class QuadSplitFlow : public testing::TestWithParam<Flow> {};

TEST_P(QuadSplitFlow, RtlMatchesModel) {
  std::mt19937 random(1);
  const FlowPattern steps = PatternOf(GetParam(), 2);
  Dut rtl;
  int64_t cycle = 0;
  for (int span = 0; span < 5000; ++span) {
    const int length = RandomLength(random);
    const Seeds seeds = span % 2 ? AnySeeds(random) : RandomSeeds(length, random);
    QuadSplit model(seeds.diffuse, seeds.split);
    rtl.Cycle(true, random() % 2, seeds.diffuse, seeds.split);
    ASSERT_EQ(rtl.code(), model.code());
    for (int left = length - 1; left > 0; ++cycle) {
      const Seeds noise = AnySeeds(random);
      const bool step = steps.At(cycle);
      rtl.Cycle(false, step, noise.diffuse, noise.split);
      if (step) {
        model.Step();
        --left;
      }
      ASSERT_EQ(rtl.code(), model.code()) << "span " << span << ", " << left << " left";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(AllFlows, QuadSplitFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(QuadSplit, ContractMatchesRtl) {
  EXPECT_EQ(Dut::kLatency, QuadSplit::kContract.latency_cycles);
  EXPECT_EQ(QuadSplit::kContract.interval_cycles, 1);
  Dut rtl;
  for (int64_t code = 0; code < 16; ++code) {
    rtl.Cycle(true, true, {}, {{}, IntensityAcc::FromRaw(code * kOneCode)});
    EXPECT_EQ(rtl.code(), code) << "one cycle later, every cycle";
  }
}

// ambient + max(0, D) + max(0, S) of the parabolas through the seeds, in 128 bits.
TEST(QuadSplit, ModelMatchesClosedForm) {
  std::mt19937 random(2);
  const auto at = [](const ChannelSeed& s, int64_t t) {
    return static_cast<Int128>(s.first.raw()) + s.difference.raw() * static_cast<Int128>(t) +
           s.curvature.raw() * static_cast<Int128>(t * (t - 1) / 2);
  };
  for (int span = 0; span < 3000; ++span) {
    const int length = RandomLength(random);
    const Seeds seeds = RandomSeeds(length, random);
    QuadSplit model(seeds.diffuse, seeds.split);
    for (int t = 0; t < length; ++t, model.Step()) {
      const Int128 sum = seeds.split.ambient.raw() + std::max<Int128>(at(seeds.diffuse, t), 0) +
                         std::max<Int128>(at(seeds.split.specular, t), 0);
      ASSERT_EQ(model.code(), std::min<Int128>(sum >> IntensityAcc::kFraction, 255))
          << "span " << span << " pixel " << t;
    }
  }
}

double Bound(int t) { return 2 * std::ldexp(1 + t + 0.5 * t * (t - 1.0), -27); }

QuadSplit ModelOf(const RealCurve& diffuse, const RealCurve& specular, int64_t ambient) {
  return QuadSplit(diffuse.SeedOfDifferences(),
                   {specular.SeedOfDifferences(), IntensityAcc::FromRaw(ambient)});
}

// |sum of the model - ambient - max(0, D(t)) - max(0, S(t))| of the real parabolas, in codes.
double SumError(const QuadSplit& model, const RealCurve& diffuse, const RealCurve& specular,
                int64_t ambient, int t) {
  const long double real = std::max(diffuse.At(t), 0.0L) + std::max(specular.At(t), 0.0L);
  const long double sum = std::ldexp(static_cast<long double>(model.sum() - ambient), -26);
  return static_cast<double>(std::abs(sum - real));
}

double LastError(const RealCurve& diffuse, const RealCurve& specular) {
  QuadSplit model = ModelOf(diffuse, specular, kHalfCode);
  for (int t = 0; t + 1 < kBoundedLength; ++t) model.Step();
  return SumError(model, diffuse, specular, kHalfCode, kBoundedLength - 1);
}

// Small moves of both parabolas, in fractions of the ulp to which their seeds are rounded.
double ClimbedError(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  std::array<RealCurve, 2> best = {RandomCurve(random), RandomCurve(random)};
  double worst = LastError(best[0], best[1]);
  for (int step = 0; step < 4000; ++step) {
    const double reach = std::ldexp(1, -26 - static_cast<int>(random() % 10));
    std::array<RealCurve, 2> next = best;
    RealCurve& moved = next[random() % 2];
    moved = {moved.a + reach * unit(random), moved.d + reach * unit(random),
             moved.f + reach * unit(random)};
    const double error = LastError(next[0], next[1]);
    if (error <= worst) continue;
    best = next;
    worst = error;
  }
  return worst;
}

TEST(QuadSplit, ModelWithinErrorBound) {
  std::mt19937 random(3);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const RealCurve diffuse = RandomCurve(random), specular = RandomCurve(random);
    const int64_t ambient = static_cast<int64_t>(random() % 256) * kOneCode + kHalfCode;
    QuadSplit model = ModelOf(diffuse, specular, ambient);
    for (int t = 0; t < kBoundedLength; ++t, model.Step()) {
      const double error = SumError(model, diffuse, specular, ambient, t);
      ASSERT_LE(error, Bound(t)) << "pair " << i << " pixel " << t;
      worst = std::max(worst, error);
    }
  }
  for (int start = 0; start < 6; ++start) worst = std::max(worst, ClimbedError(random));
  const double bound = Bound(kBoundedLength - 1);
  EXPECT_LE(bound, QuadSplit::kContract.max_error_ulp);
  EXPECT_GT(bound, 0.99 * QuadSplit::kContract.max_error_ulp);
  EXPECT_LE(worst, bound);
  EXPECT_GT(worst, 0.98 * bound) << "the search is blind";
  RecordProperty("worst_permille_of_bound", static_cast<int>(1000 * worst / bound));
}

std::vector<int> Codes(Dut* rtl, const Seeds& seeds, int length) {
  std::vector<int> codes;
  QuadSplit model(seeds.diffuse, seeds.split);
  for (int t = 0; t < length; ++t) {
    rtl->Cycle(t == 0, t > 0, seeds.diffuse, seeds.split);
    if (t > 0) model.Step();
    EXPECT_EQ(rtl->code(), model.code());
    codes.push_back(rtl->code());
  }
  return codes;
}

ChannelSeed Line(int first, int difference) {
  return SeedOf(first * kOneCode, 0, difference * kOneCode, 0);
}

TEST(QuadSplit, TermsAreClampedApart) {
  Dut rtl;
  const IntensityAcc ambient = IntensityAcc::FromRaw(10 * kOneCode);
  // D = -4, -2, 0, 2; S = 5, 2, -1, -4.
  EXPECT_EQ(Codes(&rtl, {Line(-4, 2), {Line(5, -3), ambient}}, 4),
            (std::vector<int>{15, 12, 10, 12}));
}

TEST(QuadSplit, SumSaturates) {
  Dut rtl;
  const IntensityAcc ambient = IntensityAcc::FromRaw(255 * kOneCode + kHalfCode);
  // 255.5 + 420 + 340: beyond S9.26, within S10.26.
  EXPECT_EQ(Codes(&rtl, {Line(420, -200), {Line(340, -200), ambient}}, 3),
            (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(Codes(&rtl, {Line(100, 1), {Line(155, 0), {}}}, 3), (std::vector<int>{255, 255, 255}));
  EXPECT_EQ(Codes(&rtl, {Line(100, -1), {Line(155, 0), {}}}, 3), (std::vector<int>{255, 254, 253}));
}

TEST(QuadSplit, LoadWinsOverStepAndIdleHolds) {
  Dut rtl;
  rtl.Cycle(true, true, Line(10, 5), {});
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, false, Line(99, 9), {});
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, true, Line(99, 9), {});
  EXPECT_EQ(rtl.code(), 15);
  rtl.Cycle(true, true, Line(20, 0), {});
  EXPECT_EQ(rtl.code(), 20);
}

}  // namespace
}  // namespace shading
