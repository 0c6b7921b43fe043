// SPDX-License-Identifier: Apache-2.0
#include "model/normal/slerp_direct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <random>

#include "tb/dut/slerp_direct_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/arc_stimulus.h"

namespace shading {
namespace {

// Of a span, or any bits.
SpanArc RandomSpanArc(int length, std::mt19937& random) {
  SpanArc arc;
  if (random() % 4) {
    const PixelSeed seed = SeedOf(SpanOf(RandomPlane(random), RandomTurn(random), length));
    return SlerpDirectSetup::Of(seed.quantity, seed.kappa);
  }
  const auto bits = [&random] {
    const auto word = static_cast<int32_t>(random());
    return SpanNormalComponent::FromRaw(random() % 8   ? word >> (random() % 32)
                                        : random() % 2 ? INT32_MIN
                                                       : INT32_MAX);
  };
  for (size_t i = 0; i < 3; ++i) arc.start[i] = bits(), arc.side[i] = bits();
  const uint64_t step = static_cast<uint64_t>(random()) << 32 | random();
  arc.step = Angle::FromRaw(static_cast<int64_t>(step >> (23 + random() % 41)));
  return arc;
}

// Walks spans through RTL and model: the pixel of the moment leaves in the willing cycles, and in
// that cycle the walker steps or loads the next span. Between spans the unit may wait.
template <typename Dut>
void ExpectSameNormals(Flow flow, int spans) {
  std::mt19937 random(1);
  const FlowPattern leaves = PatternOf(flow, 2);
  Dut rtl;
  std::deque<std::pair<int64_t, PixelNormal>> due;
  int64_t cycle = 0;
  const auto clock = [&](bool load, bool step, bool valid, const SpanArc& arc) {
    rtl.Cycle(load, step, valid, arc);
    const bool expected = !due.empty() && due.front().first == cycle;
    ASSERT_EQ(rtl.valid(), expected) << "cycle " << cycle;
    if (expected) {
      ASSERT_EQ(rtl.output(), due.front().second) << "cycle " << cycle;
      due.pop_front();
    }
    ++cycle;
  };
  SpanArc arc = RandomSpanArc(1, random);
  clock(true, false, false, arc);
  for (int span = 0; span < spans; ++span) {
    SCOPED_TRACE("span " + std::to_string(span));
    const int length = span % 4 ? 1 + static_cast<int>(random() % 3) : RandomSpanLength(random);
    SpanArc next = RandomSpanArc(length, random);
    SlerpDirect model(arc, Dut::kLane, Dut::kLanes);
    const bool idle = random() % 8 == 0;
    for (int left = length; left > 0;) {
      const bool leave = leaves.At(cycle), last = left == 1;
      if (leave) due.emplace_back(cycle + Dut::kLatency - 1, model.normal());
      ASSERT_NO_FATAL_FAILURE(
          clock(leave && last && !idle, leave && (!last || random() % 2), leave, next));
      if (leave) model.Step(), --left;
    }
    for (int wait = idle ? static_cast<int>(random() % 40) : 0; wait > 0; --wait) {
      ASSERT_NO_FATAL_FAILURE(clock(false, random() % 2, false, arc));
    }
    if (idle) {
      ASSERT_NO_FATAL_FAILURE(clock(true, random() % 2, false, next));
    }
    arc = next;
  }
  while (!due.empty()) ASSERT_NO_FATAL_FAILURE(clock(false, false, false, arc));
}

class SlerpDirectFlow : public testing::TestWithParam<Flow> {};

TEST_P(SlerpDirectFlow, RtlMatchesModel) {
  ExpectSameNormals<tb::SlerpDirectDut>(GetParam(), 3000);
  ExpectSameNormals<tb::SlerpDirectLane3Dut>(GetParam(), 3000);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, SlerpDirectFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

SpanArc ArcOf(const Plane& plane, Real step) {
  return {Angle::FromRaw(std::llround(std::ldexp(step, Angle::kFraction))),
          RoundNormal(plane.start), RoundNormal(plane.side)};
}

TEST(SlerpDirect, ContractMatchesRtl) {
  using Dut = tb::SlerpDirectDut;
  EXPECT_EQ(Dut::kLatency, SlerpDirect::kContract.latency_cycles);
  const SpanArc arc = ArcOf({{1, 0, 0}, {0, 1, 0}}, 0.01L);
  Dut rtl;
  EXPECT_FALSE(rtl.valid()) << "after reset";
  rtl.Cycle(true, false, false, arc);
  int cycles = 1;
  for (rtl.Cycle(false, true, true, arc); !rtl.valid() && cycles < 64; ++cycles) {
    rtl.Cycle(false, false, false, arc);
  }
  EXPECT_EQ(cycles, SlerpDirect::kContract.latency_cycles);
  int seen = 0;
  for (int i = 0; i < 64 + cycles - 1; ++i) {
    rtl.Cycle(false, true, i < 64, arc);
    seen += rtl.valid();
  }
  EXPECT_EQ(seen, 64 / SlerpDirect::kContract.interval_cycles);
}

Real Distance(const PixelNormal& normal, const RealVector& ideal) {
  Real worst = 0;
  for (size_t i = 0; i < 3; ++i) {
    const Real actual = static_cast<Real>(normal[i].raw());
    worst = std::max(worst, std::abs(actual - std::ldexp(ideal[i], 24)));
  }
  return worst;
}

// In ulp of 2^-24, of the first pixel of lane 1: the angle is the step.
Real OwnError(const SpanArc& arc) {
  const Real angle = std::ldexp(static_cast<Real>(arc.step.raw()), -Angle::kFraction);
  const RealVector start = RealOf(arc.start), side = RealOf(arc.side);
  RealVector ideal;
  for (size_t i = 0; i < 3; ++i) {
    ideal[i] = start[i] * std::cos(angle) + side[i] * std::sin(angle);
  }
  return Distance(SlerpDirect(arc, 1, 1).normal(), ideal);
}

// Random arcs and angles, then small moves away from the worst of them.
TEST(SlerpDirect, ModelWithinErrorBound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1.74);
  std::normal_distribution<double> move;
  Real worst = 0;
  for (int climb = 0; climb < 20; ++climb) {
    Plane best{};
    Real best_angle = 0, top = -1, size = 1e-3L;
    for (int i = 0; i < 60000; ++i) {
      Plane plane = RandomPlane(random);
      Real angle = uniform(random);
      if (i > 30000) {
        size *= 0.9996L;
        plane = best;
        for (size_t c = 0; c < 3; ++c) plane.start[c] += size * static_cast<Real>(move(random));
        plane = PlaneOf(plane.start, plane.side);
        angle = std::clamp(best_angle + size * static_cast<Real>(move(random)), 0.0L, 1.74L);
      }
      const Real error = OwnError(ArcOf(plane, angle));
      if (error > top) top = error, best = plane, best_angle = angle;
    }
    worst = std::max(worst, top);
  }
  RecordProperty("worst_milliulp", static_cast<int>(worst * 1000));
  EXPECT_LE(worst, SlerpDirect::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.6) << "the search is blind";
}

// All pixels of a span against slerp of its ends, in ulp of 2^-24; through both set-up units.
Real SpanError(const SpanCommand& span, int stride) {
  const PixelSeed seed = SeedOf(span);
  const RealVector a = RealOf(span.normal[0]), b = RealOf(span.normal[1]);
  const RealVector unit_a = Unit(a), unit_b = Unit(b);
  RealVector chord;
  for (size_t i = 0; i < 3; ++i) chord[i] = unit_b[i] - unit_a[i];
  const Real psi = 2 * std::asin(std::sqrt(Dot(chord, chord)) / 2);
  SlerpDirect model(SlerpDirectSetup::Of(seed.quantity, seed.kappa), 0, stride);
  const int m = span.length - 1;
  Real worst = 0;
  for (int t = 0; t <= m; t += stride, model.Step()) {
    const Real w = static_cast<Real>(t) / m;
    const Real wa = psi == 0 ? 1 - w : std::sin((1 - w) * psi) / std::sin(psi);
    const Real wb = psi == 0 ? w : std::sin(w * psi) / std::sin(psi);
    worst = std::max(worst, Distance(model.normal(), {wa * a[0] + wb * b[0], wa * a[1] + wb * b[1],
                                                      wa * a[2] + wb * b[2]}));
  }
  return worst;
}

// Random spans, then small moves away from the worst of them.
Real ClimbSpans(int longest, std::mt19937& random) {
  std::normal_distribution<double> move;
  Plane best{};
  Real best_turn = 0, worst = -1, size = 0.03L;
  int best_length = 2;
  for (int i = 0; i < 800; ++i) {
    Plane plane = RandomPlane(random);
    Real turn = RandomTurn(random);
    int length = 2 + static_cast<int>(random() % (2u << random() % 12));
    length = random() % 2 ? longest : std::min(length, longest);
    if (i > 400) {
      size *= 0.98L;
      plane = best;
      for (size_t c = 0; c < 3; ++c) plane.start[c] += size * static_cast<Real>(move(random));
      plane = PlaneOf(plane.start, plane.side);
      turn = std::min(kQuarterTurn, best_turn * std::exp(size * static_cast<Real>(move(random))));
      length = best_length;
    }
    const Real error = SpanError(SpanOf(plane, turn, length), 1 + length / 512);
    if (error > worst) worst = error, best = plane, best_turn = turn, best_length = length;
  }
  return worst;
}

// 2^-23 = 2 ulp, set-up included.
TEST(SlerpDirect, SpansFollowSlerp) {
  std::mt19937 random(1);
  for (const int longest : {64, 2048, 4096}) {
    Real worst = 0;
    for (int climb = 0; climb < 6; ++climb) worst = std::max(worst, ClimbSpans(longest, random));
    RecordProperty("worst_milliulp_" + std::to_string(longest), static_cast<int>(worst * 1000));
    EXPECT_LE(worst, 2) << longest << " pixels";
    EXPECT_GT(worst, 0.6) << "the search is blind";
  }
}

// Lane j of k shows the pixels j, j + k, ... of one lane.
TEST(SlerpDirect, LanesShareTheSpan) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const SpanArc arc = RandomSpanArc(64, random);
    SlerpDirect one(arc);
    std::array<SlerpDirect, 4> four = {SlerpDirect(arc, 0, 4), SlerpDirect(arc, 1, 4),
                                       SlerpDirect(arc, 2, 4), SlerpDirect(arc, 3, 4)};
    for (size_t t = 0; t < 64; ++t, one.Step()) {
      ASSERT_EQ(four[t % 4].normal(), one.normal()) << t;
      four[t % 4].Step();
    }
  }
}

// At t = 0 and a quarter of a turn the normals are start and side.
TEST(SlerpDirect, AxesComeBack) {
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const Plane plane = RandomPlane(random);
    SlerpDirect model(ArcOf(plane, kQuarterTurn));
    ASSERT_LE(Distance(model.normal(), plane.start), 0.75L);
    model.Step();
    ASSERT_LE(Distance(model.normal(), plane.side), 0.75L);
  }
}

TEST(SlerpDirect, SumsSaturate) {
  SpanArc arc;
  arc.step = Angle::FromRaw(int64_t{0x3243f6a8} << 10);  // an eighth of a turn
  for (size_t i = 0; i < 3; ++i) {
    arc.start[i] = arc.side[i] = SpanNormalComponent::FromRaw(i == 1 ? INT32_MIN : INT32_MAX);
  }
  const PixelNormal normal = SlerpDirect(arc, 1).normal();
  EXPECT_EQ(normal[0].raw(), (1 << 25) - 1);
  EXPECT_EQ(normal[1].raw(), -(1 << 25));
}

}  // namespace
}  // namespace shading
