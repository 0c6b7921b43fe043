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

// RTL beside what it owes: normals of the model, each due kLatency cycles after its pixel.
template <typename Dut>
class Walk {
 public:
  int64_t cycle() const { return cycle_; }
  bool owes() const { return !due_.empty(); }

  void Leave(const PixelNormal& normal) {
    due_.emplace_back(cycle_ + Dut::kLatency - 1, normal);
    leaves_ = true;
  }
  void Clock(bool load, bool step, const SpanArc& arc) {
    rtl_.Cycle(load, step, leaves_, arc);
    leaves_ = false;
    const bool expected = owes() && due_.front().first == cycle_;
    ASSERT_EQ(rtl_.valid(), expected) << "cycle " << cycle_;
    if (expected) {
      ASSERT_EQ(rtl_.output(), due_.front().second) << "cycle " << cycle_;
      due_.pop_front();
    }
    ++cycle_;
  }

 private:
  Dut rtl_;
  std::deque<std::pair<int64_t, PixelNormal>> due_;
  int64_t cycle_ = 0;
  bool leaves_ = false;
};

// The pixel of the moment leaves in the willing cycles, and in that cycle the walker steps or loads
// the next span. Every other 64 spans are single pixels in a row; else the unit may wait between.
template <typename Dut>
void ExpectSameNormals(Flow flow, int spans) {
  std::mt19937 random(1);
  const FlowPattern leaves = PatternOf(flow, 2);
  Walk<Dut> walk;
  SpanArc arc = RandomSpanArc(2, random);
  walk.Clock(true, false, arc);
  for (int span = 0; span < spans; ++span) {
    SCOPED_TRACE("span " + std::to_string(span));
    const bool burst = span / 64 % 2 == 1, idle = !burst && random() % 8 == 0;
    const int length = burst ? 1 : RandomSpanLength(random);
    const SpanArc next = RandomSpanArc(2 + static_cast<int>(random() % 64), random);
    SlerpDirect model(arc, Dut::kLane, Dut::kLanes);
    for (int left = length; left > 0;) {
      const bool leave = leaves.At(walk.cycle()), last = left == 1;
      if (leave) walk.Leave(model.normal());
      const bool step = leave && (!last || random() % 2);
      ASSERT_NO_FATAL_FAILURE(walk.Clock(leave && last && !idle, step, next));
      if (leave) model.Step(), --left;
    }
    for (int wait = idle ? 1 + static_cast<int>(random() % 40) : 0; wait > 0; --wait) {
      ASSERT_NO_FATAL_FAILURE(walk.Clock(wait == 1, random() % 2, next));
    }
    arc = next;
  }
  while (walk.owes()) ASSERT_NO_FATAL_FAILURE(walk.Clock(false, false, arc));
}

class SlerpDirectFlow : public testing::TestWithParam<Flow> {};

TEST_P(SlerpDirectFlow, RtlMatchesModel) {
  ExpectSameNormals<tb::SlerpDirectDut>(GetParam(), 3000);
  ExpectSameNormals<tb::SlerpDirectLane3Dut>(GetParam(), 3000);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, SlerpDirectFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

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

// Pixels of a span against slerp of its ends, in ulp of 2^-24; through both set-up units.
Real SpanError(const SpanCommand& span, int stride) {
  const PixelSeed seed = SeedOf(span);
  const Real turn = TurnOf(span);
  SlerpDirect model(SlerpDirectSetup::Of(seed.quantity, seed.kappa), 0, stride);
  const int m = span.length - 1;
  Real worst = 0;
  for (int t = 0; t <= m; t += stride, model.Step()) {
    worst =
        std::max(worst, Distance(model.normal(), SlerpOf(span, turn, static_cast<Real>(t) / m)));
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
