// SPDX-License-Identifier: Apache-2.0
#include "model/normal/slerp_recurrence.h"

#include <gtest/gtest.h>

#include <vector>

#include "tb/dut/slerp_recurrence_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/quantity_stimulus.h"

namespace shading {
namespace {

constexpr int kBoundedLength = 2048;  // pixels for which the contract states its error

struct Bench {
  using Model = SlerpRecurrence;
  using Dut = tb::SlerpRecurrenceDut;
  static constexpr int kLanes = 1;

  static Model Make(const QuantityStart& start) {
    return Model(start.seed[0], start.step_kappa[0]);
  }
  static void Cycle(Dut& rtl, bool load, bool step, const QuantityStart& start) {
    rtl.Cycle(load, step, start.seed[0], start.step_kappa[0]);
  }
  template <typename Source>
  static Quantity Value(const Source& source, int) {
    return source.value();
  }
};

class SlerpRecurrenceFlow : public testing::TestWithParam<Flow> {};

TEST_P(SlerpRecurrenceFlow, RtlMatchesModel) {
  ExpectSameValues<Bench>(PatternOf(GetParam(), 1), 10000, 2);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, SlerpRecurrenceFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(SlerpRecurrence, ContractMatchesRtl) { ExpectTiming<Bench>(SlerpRecurrence::kContract); }

TEST(SlerpRecurrence, LoadWinsOverStepAndIdleHolds) { ExpectLoadWinsAndIdleHolds<Bench>(); }

// The bound of the page in ulp of 2^-28 at steps 0 .. steps of `phi`: every step adds at most
// `added` to the second difference, which Green's function sin(n phi) / sin(phi) carries on.
std::vector<Real> Bounds(Real phi, int steps) {
  const Kappa kappa = KappaOf(phi);
  const Real sine = std::sin(phi), half = std::sin(phi / 2);
  const Real added = (std::ldexp(1.0001L, -29 - 2 * kappa.exponent) +
                      1.0001L * 4 * half * half * std::ldexp(1.0L, -29) + std::ldexp(1.0L, -39));
  std::vector<Real> bounds;
  Real carried = 0;
  for (int t = 0; t <= steps; ++t) {
    const Real green = std::abs(std::sin(t * phi) / sine);
    const Real seeds = std::abs(std::cos((t - 0.5L) * phi) / std::cos(phi / 2)) + green;
    bounds.push_back(std::ldexp(carried * added + std::ldexp(seeds, -39), 28));
    carried += green;
  }
  return bounds;
}

Real Ulps(Quantity value, Real ideal) { return std::ldexp(std::abs(ToReal(value) - ideal), 28); }

// Error of the last pixel of an arc of which every stride-th pixel is walked.
Real LastError(const Arc& arc, int steps, int stride = 1) {
  SlerpRecurrence model(arc.Seed(0, stride), KappaOf(arc.phi * stride));
  for (int t = 0; t < steps; ++t) model.Step();
  return Ulps(model.value(), arc.At(steps * stride));
}

TEST(SlerpRecurrence, EveryPixelWithinErrorBound) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const int length = i % 2 ? kBoundedLength : 1 + static_cast<int>(random() % 4096);
    const Arc arc = RandomArc(length, random);
    if (arc.phi > kQuarterTurn) continue;
    const std::vector<Real> bounds = Bounds(arc.phi, length);
    SlerpRecurrence model(arc.Seed(0, 1), KappaOf(arc.phi));
    for (int t = 0; t < length; ++t, model.Step()) {
      ASSERT_LE(Ulps(model.value(), arc.At(t)), bounds[static_cast<size_t>(t)])
          << "phi " << static_cast<double>(arc.phi) << " pixel " << t;
    }
  }
}

// Random arcs, then small moves away from the worst of them.
Real WorstLastError(int steps, int stride, uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> move(0, 1);
  Real overall = 0;
  for (int climb = 0; climb < 8; ++climb) {
    Arc worst_arc{};
    Real worst = -1, size = 1e-2L;
    for (int i = 0; i<800; ++i, size *= i> 400 ? 0.98L : 1) {
      Arc arc = RandomArc(steps * stride + 1, random);
      if (i > 400) {
        arc = {worst_arc.phi * (1 + size * static_cast<Real>(move(random))),
               worst_arc.start + size * static_cast<Real>(move(random))};
        if (arc.phi * steps * stride > kQuarterTurn) continue;
      }
      const Real error = LastError(arc, steps, stride);
      if (error > worst) worst = error, worst_arc = arc;
    }
    overall = std::max(overall, worst);
  }
  return overall;
}

Real WorstBound(int steps) {
  Real worst = 0;
  for (int i = 0; i <= 300; ++i) {  // up to 90 degrees
    const Real turn = kQuarterTurn * std::pow(10.0L, -i / 50.0L);
    worst = std::max(worst, Bounds(turn / steps, steps).back());
  }
  return worst;
}

TEST(SlerpRecurrence, ModelWithinErrorBound) {
  const Real worst = WorstLastError(kBoundedLength - 1, 1, 3);
  const Real bound = WorstBound(kBoundedLength - 1);
  RecordProperty("worst_ulp28_2048", static_cast<int>(worst));
  RecordProperty("bound_ulp28_2048", static_cast<int>(std::ceil(bound)));
  EXPECT_LE(bound, SlerpRecurrence::kContract.max_error_ulp);
  EXPECT_LE(worst, bound);
  EXPECT_GT(worst, 0.8L * bound) << "the search is blind";
}

TEST(SlerpRecurrence, LongestSpansWithinErrorBound) {
  const Real worst = WorstLastError(4095, 1, 4), bound = WorstBound(4095);
  RecordProperty("worst_ulp28_4096", static_cast<int>(worst));
  RecordProperty("bound_ulp28_4096", static_cast<int>(std::ceil(bound)));
  EXPECT_LE(worst, bound);
  EXPECT_LE(bound, 4100);  // as on the page
}

// kappa s(t) stays just under half a unit of 2^-38: the curve is drawn as a straight line.
TEST(SlerpRecurrence, SmallestAnglesAttainTheBound) {
  const Real phi = std::sqrt(std::ldexp(0.99L, -39));
  const Arc arc{phi, -phi / 2};
  EXPECT_GT(LastError(arc, kBoundedLength - 1), 0.95L * Bounds(phi, kBoundedLength - 1).back());
}

// Lane j of four starts at pixel j; seeds and kappa span four pixels.
TEST(SlerpRecurrence, FourLanesWithinErrorBound) {
  std::mt19937 random(5);
  for (int i = 0; i < 1000; ++i) {
    const int groups = i % 2 ? kBoundedLength / 4 : 1 + static_cast<int>(random() % 1024);
    const Arc arc = RandomArc(4 * groups, random);
    if (4 * arc.phi > kQuarterTurn) continue;
    const std::vector<Real> bounds = Bounds(4 * arc.phi, groups);
    const QuantityStart start = arc.Start(4);
    for (int lane = 0; lane < kMaxLanes; ++lane) {
      SlerpRecurrence model(start.seed[static_cast<size_t>(lane)], KappaOf(4 * arc.phi));
      for (int t = 0; t < groups; ++t, model.Step()) {
        ASSERT_LE(Ulps(model.value(), arc.At(4 * t + lane)), bounds[static_cast<size_t>(t)])
            << "lane " << lane << " phi " << static_cast<double>(arc.phi) << " group " << t;
      }
    }
  }
  const Real worst = WorstLastError(kBoundedLength / 4 - 1, 4, 6);
  RecordProperty("worst_ulp28_2048_lanes4", static_cast<int>(worst));
  EXPECT_LE(worst, WorstBound(kBoundedLength / 4 - 1));
}

TEST(SlerpRecurrence, KappaZeroIsALine) {
  SlerpRecurrence model({Quantity::Round(-1), Quantity::Round(0.125)}, {});
  for (int t = 0; t < 17; ++t, model.Step()) EXPECT_EQ(model.value().ToReal(), -1 + 0.125 * t);
}

TEST(SlerpRecurrence, SixtyDegreesAStepRepeatsExactly) {
  // kappa = 1 has no rounding: 1, 1/2, -1/2, -1, -1/2, 1/2, 1, ...
  const Kappa kappa = {U<1, 28>::Round(1), 0};
  SlerpRecurrence model({Quantity::Round(1), Quantity::Round(-0.5)}, kappa);
  constexpr std::array<double, 6> kTurn = {1, 0.5, -0.5, -1, -0.5, 0.5};
  for (size_t t = 0; t < 600; ++t, model.Step()) EXPECT_EQ(model.value().ToReal(), kTurn[t % 6]);
}

TEST(SlerpRecurrence, OverflowWrapsAlikeInRtl) {
  QuantityStart start;
  start.seed[0] = {Quantity::Wrap(2 * kOneQuantity - 1), Quantity::Wrap(2 * kOneQuantity - 1)};
  start.step_kappa[0] = {U<1, 28>::FromRaw(U<1, 28>::kMaxRaw), 0};
  Bench::Dut rtl;
  SlerpRecurrence model = Bench::Make(start);
  Bench::Cycle(rtl, true, false, start);
  for (int t = 0; t < 100; ++t, model.Step()) {
    ASSERT_EQ(rtl.value(), model.value()) << t;
    Bench::Cycle(rtl, false, true, start);
  }
}

}  // namespace
}  // namespace shading
