// SPDX-License-Identifier: Apache-2.0
#include "model/normal/slerp_direct_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/normal/slerp_direct_setup_table.h"
#include "tb/dut/slerp_direct_setup_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/arc_stimulus.h"

namespace shading {
namespace {

using Dut = tb::SlerpDirectSetupDut;

SpanArc ArcOf(const PixelSeed& seed) { return SlerpDirectSetup::Of(seed.quantity, seed.kappa); }

// Of a span, of an arc of any angle, straight ones around the borders of their kinds, or anything.
PixelSeed RandomSeed(std::mt19937& random) {
  const int kind = static_cast<int>(random() % 8);
  PixelSeed seed;
  if (kind < 3) {
    const int length = kind == 0 ? 2 + static_cast<int>(random() % 3) : RandomSpanLength(random);
    const Real turn = kind == 2 ? std::ldexp(RandomTurn(random), -10) : RandomTurn(random);
    return SeedOf(SpanOf(RandomPlane(random), turn, length));
  }
  seed.kappa = RandomKappa(random);
  if (kind == 3) seed.kappa.mantissa = {};
  const int border = random() % 2 ? 19 : 14;
  for (QuantitySeed& quantity : seed.quantity) {
    quantity = {RandomQuantity(random), RandomQuantity(random)};
    if (kind > 4) continue;
    const int64_t near = static_cast<int64_t>(random() % 5) - 2;
    const int64_t edge = (random() % 2 ? 1 : -1) * (int64_t{1} << border);
    quantity.difference = Quantity::Wrap(random() % 4 ? near : edge + near);
  }
  return seed;
}

// The timing rule of the model's header.
void ExpectCycles(const Dut::Result& result, const FlowPattern& seed, const FlowPattern& arc) {
  constexpr auto kStages = static_cast<size_t>(SlerpDirectSetup::kStages);
  std::vector<int64_t> before(kStages + 2, 0), now(kStages + 2);
  int64_t next = 0;
  for (size_t k = 0; k < result.seeds.size(); ++k, before = now) {
    now[0] = std::max(seed.Next(next), before[1]);
    for (size_t j = 0; j < kStages; ++j) {
      now[j + 1] = std::max(now[j] + NormalSetup::kSteps, before[j + 2]);
    }
    now[kStages + 1] = arc.Next(now[kStages] + 1);
    ASSERT_EQ(result.seeds[k], now[0]) << "seed " << k;
    ASSERT_EQ(result.arcs[k].offered, now[kStages] + 1) << "seed " << k;
    ASSERT_EQ(result.arcs[k].taken, now[kStages + 1]) << "seed " << k;
    next = now[0] + 1;
  }
}

void ExpectArc(const SpanArc& rtl, const SpanArc& model) {
  ASSERT_EQ(rtl.step.raw(), model.step.raw());
  for (size_t i = 0; i < 3; ++i) {
    ASSERT_EQ(rtl.start[i].raw(), model.start[i].raw()) << i;
    ASSERT_EQ(rtl.side[i].raw(), model.side[i].raw()) << i;
  }
}

TEST(SlerpDirectSetup, RtlMatchesModel) {
  std::mt19937 random(1);
  Dut rtl;
  for (const Flow seed_flow : {Flow::kAlways, Flow::kOneInFour, Flow::kRandom}) {
    for (const Flow arc_flow : {Flow::kAlways, Flow::kOneInFour, Flow::kRandom}) {
      SCOPED_TRACE(NameOf(seed_flow) + " seeds, arcs " + NameOf(arc_flow));
      std::vector<Dut::Seed> seeds;
      for (int i = 0; i < 20000; ++i) {
        const PixelSeed seed = RandomSeed(random);
        seeds.push_back({seed.quantity,
                         seed.kappa,
                         {static_cast<uint32_t>(random()), static_cast<uint32_t>(random()),
                          static_cast<uint32_t>(random()), static_cast<uint32_t>(random()) >> 3}});
      }
      const FlowPattern offers = PatternOf(seed_flow, 1), takes = PatternOf(arc_flow, 2);
      const Dut::Result result = rtl.Run(seeds, offers, takes);
      ASSERT_EQ(result.failure, "");
      ASSERT_NO_FATAL_FAILURE(ExpectCycles(result, offers, takes));
      for (size_t i = 0; i < seeds.size(); ++i) {
        ASSERT_NO_FATAL_FAILURE(
            ExpectArc(result.arcs[i].arc, SlerpDirectSetup::Of(seeds[i].quantity, seeds[i].kappa)))
            << "seed " << i << " kappa " << seeds[i].kappa.mantissa.raw() << " 4^-"
            << seeds[i].kappa.exponent;
        ASSERT_EQ(result.arcs[i].run, seeds[i].run) << "seed " << i;
      }
    }
  }
}

TEST(SlerpDirectSetup, ContractMatchesRtl) {
  EXPECT_EQ(Dut::kLatency, SlerpDirectSetup::kContract.latency_cycles);
  EXPECT_EQ(Dut::kLatency, SlerpDirectSetup::kStages * NormalSetup::kSteps + 1);
  EXPECT_EQ(Dut::kInterval, SlerpDirectSetup::kContract.interval_cycles);
  EXPECT_EQ(Dut::kInterval, NormalSetup::kSteps);
}

// Distance in ulp of 2^-30 at pixel t between the arc and the great circle through N(0) and N(1)
// that turns by phi a step, 4 sin^2(phi/2) = kappa; a straight line for kappa = 0.
Real Distance(const PixelSeed& seed, const SpanArc& arc, int t) {
  const Real kappa =
      std::ldexp(static_cast<Real>(seed.kappa.mantissa.raw()), -28 - 2 * seed.kappa.exponent);
  const Real phi = 2 * std::asin(std::sqrt(kappa) / 2);
  const Real angle = t * std::ldexp(static_cast<Real>(arc.step.raw()), -Angle::kFraction);
  const RealVector start = RealOf(arc.start), side = RealOf(arc.side);
  Real worst = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Real first = ToReal(seed.quantity[i].first), d = ToReal(seed.quantity[i].difference);
    const Real ideal = kappa == 0 ? first + t * d
                                  : first * std::cos(t * phi) +
                                        (d + first * kappa / 2) * std::sin(t * phi) / std::sin(phi);
    const Real actual = start[i] * std::cos(angle) + side[i] * std::sin(angle);
    worst = std::max(worst, std::abs(actual - ideal));
  }
  return std::ldexp(worst, 30);
}

// -1 for a span of the other kind.
Real WorstOf(const SpanCommand& span, bool straight) {
  const PixelSeed seed = SeedOf(span);
  if ((seed.kappa.mantissa.raw() == 0) != straight) return -1;
  const SpanArc arc = ArcOf(seed);
  const int m = span.length - 1;
  Real worst = 0;
  for (const int t : {1, m / 3, m / 2, 2 * m / 3, m}) {
    worst = std::max(worst, Distance(seed, arc, t));
  }
  return worst;
}

// Random spans, then small moves away from the worst of them.
Real Climb(bool straight, std::mt19937& random) {
  std::normal_distribution<double> move;
  Plane best = RandomPlane(random);
  Real best_turn = RandomTurn(random), worst = -1, size = 0.1L;
  int best_length = 2;
  for (int i = 0; i < 3000; ++i) {
    Plane plane = RandomPlane(random);
    Real turn = straight ? std::ldexp(RandomTurn(random), -12) : RandomTurn(random);
    int length = random() % 2 ? 4096 : std::max(2, RandomSpanLength(random));
    if (i > 1500) {
      size *= 0.995L;
      for (size_t c = 0; c < 3; ++c) {
        plane.start[c] = best.start[c] + size * static_cast<Real>(move(random));
        plane.side[c] = best.side[c] + size * static_cast<Real>(move(random));
      }
      plane = PlaneOf(plane.start, plane.side);
      turn = std::min(kQuarterTurn, best_turn * std::exp(size * static_cast<Real>(move(random))));
      length = std::clamp(best_length + static_cast<int>(random() % 3) - 1, 2, 4096);
    }
    const Real error = WorstOf(SpanOf(plane, turn, length), straight);
    if (error > worst) worst = error, best = plane, best_turn = turn, best_length = length;
  }
  return worst;
}

TEST(SlerpDirectSetup, ModelWithinErrorBound) {
  std::mt19937 random(1);
  Real turned = 0, straight = 0;
  for (int climb = 0; climb < 20; ++climb) {
    turned = std::max(turned, Climb(false, random));
    straight = std::max(straight, Climb(true, random));
  }
  RecordProperty("worst_ulp_turned", std::to_string(turned));
  RecordProperty("worst_ulp_straight", std::to_string(straight));
  EXPECT_LE(turned, SlerpDirectSetup::kContract.max_error_ulp);
  EXPECT_LE(straight, SlerpDirectSetup::kContract.max_error_ulp);
  EXPECT_GT(straight, 0.8 * SlerpDirectSetup::kContract.max_error_ulp) << "the search is blind";
  EXPECT_GT(turned, 0.3 * SlerpDirectSetup::kContract.max_error_ulp) << "the search is blind";
}

TEST(SlerpDirectSetup, EqualNormalsStandStill) {
  std::mt19937 random(1);
  for (int m = 1; m < 4096; ++m) {
    const SpanArc arc = ArcOf(SeedOf(SpanOf(RandomPlane(random), 0, m + 1)));
    EXPECT_EQ(arc.step.raw(), int64_t{1} << 15);
    for (const SpanNormalComponent side : arc.side) ASSERT_EQ(side.raw(), 0);
  }
}

// A span of two pixels comes without kappa: both pixels are its ends.
TEST(SlerpDirectSetup, TwoPixelsAreTheEnds) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const Real turn = i % 2 ? RandomTurn(random) : std::ldexp(RandomTurn(random), -15);
    const SpanCommand span = SpanOf(RandomPlane(random), turn, 2);
    const PixelSeed seed = SeedOf(span);
    const SpanArc arc = ArcOf(seed);
    ASSERT_EQ(seed.kappa.mantissa.raw(), 0);
    ASSERT_EQ(arc.start, span.normal[0]);
    ASSERT_LE(Distance(seed, arc, 0), 0);
    ASSERT_LE(Distance(seed, arc, 1), 1);
    if (turn > 1e-4L) {
      ASSERT_EQ(arc.side, span.normal[1]);
    }
  }
}

// Four lanes give the same arc as one.
TEST(SlerpDirectSetup, LanesDoNotMatter) {
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {
    const SpanCommand span =
        SpanOf(RandomPlane(random), RandomTurn(random), RandomSpanLength(random));
    ASSERT_NO_FATAL_FAILURE(ExpectArc(ArcOf(SeedOf(span, 4)), ArcOf(SeedOf(span, 1))));
  }
}

void ExpectTable(const normal_setup::Table<slerp_direct_setup::kSegments>& table, Real (*f)(Real)) {
  const Real width = 1.0L / 64, c = std::sqrt(3.0L) / 2;
  const Real t1 = c / (1 + c), t2 = 2 * c / (1 + c);
  const auto close = [](int64_t raw, Real real) {
    return std::abs(static_cast<Real>(raw) - std::ldexp(real, normal_setup::kTableFraction)) <
           0.52L;
  };
  for (size_t i = 0; i < table.size(); ++i) {
    const Real start = static_cast<Real>(i) * width, f0 = f(start);
    const Real d1 = (f(start + t1 * width) - f0) / t1, d2 = (f(start + t2 * width) - f0) / t2;
    const Real curvature = (d2 - d1) / (t2 - t1);
    ASSERT_TRUE(close(table[i].value, f0)) << i;
    ASSERT_TRUE(close(table[i].slope, d1 - curvature * t1)) << i;
    ASSERT_TRUE(close(table[i].curvature, curvature)) << i;
  }
}

TEST(SlerpDirectSetup, TablesFollowTheirFunctions) {
  ExpectTable(slerp_direct_setup::kAngleOverChord,
              [](Real x) { return x == 0 ? 1 : 2 * std::asin(std::sqrt(x) / 2) / std::sqrt(x); });
  ExpectTable(slerp_direct_setup::kChordOverSine, [](Real x) { return 1 / std::sqrt(1 - x / 4); });
}

}  // namespace
}  // namespace shading
