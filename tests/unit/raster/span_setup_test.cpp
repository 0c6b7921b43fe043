// SPDX-License-Identifier: Apache-2.0
#include "model/raster/span_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "tb/dut/span_setup_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/raster/span_setup_checks.h"
#include "tests/unit/raster/span_stimulus.h"

namespace shading {
namespace {

constexpr int kTriangles = 1500;  // about 3400 spans
using Dut = tb::SpanSetupDut;

using Setting = std::tuple<Method, Flow, Flow>;
class SpanSetupFlow : public testing::TestWithParam<Setting> {};

constexpr auto kFlows = {Flow::kAlways, Flow::kOneInFour, Flow::kRandom};

TEST_P(SpanSetupFlow, RtlMatchesModel) {
  const auto [method, span, seed] = GetParam();
  for (const Flow triangle : kFlows) {
    SCOPED_TRACE("triangles " + NameOf(triangle));
    std::mt19937 random(1);
    Dut rtl;
    ExpectRun(&rtl, RandomWork(method, kTriangles, random),
              {PatternOf(triangle, 2), PatternOf(span, 3), PatternOf(seed, 4)});
  }
}

// One of each kind of start; the other forms of the surface have that of quad.
constexpr auto kKinds = {Method::kFlat,       Method::kGouraud,   Method::kQuad,
                         Method::kQuadHorner, Method::kQuadSplit, Method::kQuadCosine,
                         Method::kPhongSurface};

INSTANTIATE_TEST_SUITE_P(AllFlows, SpanSetupFlow,
                         testing::Combine(testing::ValuesIn(kKinds), testing::ValuesIn(kFlows),
                                          testing::ValuesIn(kFlows)),
                         [](const auto& setting) {
                           std::string name(Name(std::get<0>(setting.param)));
                           name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
                           return name + "Span" + NameOf(std::get<1>(setting.param)) + "Seed" +
                                  NameOf(std::get<2>(setting.param));
                         });

// A triangle of spans one row apart, as most are.
Dut::Work RowByRow(Method method, int rows) {
  std::mt19937 random(1);
  Dut::Work work = RandomWork(method, 1, random);
  const SpanCommand span = work.spans[0];
  work.spans.assign(static_cast<size_t>(rows), span);
  work.triangles[0].origin_y = 100;
  for (int k = 0; k < rows; ++k) {
    work.spans[static_cast<size_t>(k)].y = 100 + k;
    work.spans[static_cast<size_t>(k)].last = k + 1 == rows;
  }
  return work;
}

TEST(SpanSetup, ContractMatchesRtl) {
  EXPECT_EQ(Dut::kLatency, SpanSetup::kContract.latency_cycles);
  EXPECT_EQ(Dut::kInterval, SpanSetup::kContract.interval_cycles);
  EXPECT_EQ(SpanSetup::Steps(Method::kQuad, 1), SpanSetup::kContract.interval_cycles);
  for (const Method method : kSurfaceMethods) {
    Dut rtl;
    const Dut::Result result = rtl.Run(RowByRow(method, 20), AlwaysFlows());
    ASSERT_EQ(result.failure, "");
    for (size_t i = 0; i < result.spans.size(); ++i) {
      EXPECT_EQ(result.seeds[i].offered - result.spans[i], Dut::kLatency) << Name(method);
      if (i == 0) continue;
      EXPECT_EQ(result.spans[i] - result.spans[i - 1], Dut::kInterval) << Name(method);
    }
  }
}

// One row a cycle: the only wait that grows with the triangle.
TEST(SpanSetup, RowsWithoutSpansAreSteppedOver) {
  for (const Method method : {Method::kQuad, Method::kGouraud, Method::kPhongSurface}) {
    Dut::Work work = RowByRow(method, 2);
    work.triangles[0].origin_y = work.spans[0].y = 0;
    work.spans[1].y = 4095;
    EXPECT_EQ(SpanSetup::Steps(method, 4095), 4095);
    Dut rtl;
    ExpectRun(&rtl, work, AlwaysFlows());
  }
}

constexpr Method kClosedForms[] = {Method::kFlat, Method::kGouraud, Method::kQuad};

TEST(SpanSetup, ModelWithinErrorBound) {
  std::mt19937 random(1);
  int in_range = 0;
  for (int i = 0; i < 300000; ++i) {
    const Method method = kClosedForms[random() % 3];
    const Dut::Work work = RandomWork(method, 1, random);
    const int x = work.spans.back().x - work.triangles[0].origin_x;
    const int y = work.spans.back().y - work.triangles[0].origin_y;
    const SpanSeed seed = SpanSetup::Seed(method, work.triangles[0], work.spans.back());
    for (size_t ch = 0; ch < kChannels; ++ch) {
      const Surface& s = work.triangles[0].surface[ch];
      const Int128 first = Polynomial(s, method, x, y), second = Polynomial(s, method, x + 1, y);
      const auto wrapped = [](Int128 z) { return IntensityAcc::Wrap(static_cast<int64_t>(z)); };
      ASSERT_EQ(seed.channel[ch].first, wrapped(first));
      if (method != Method::kFlat) {
        ASSERT_EQ(seed.channel[ch].difference, wrapped(second - first));
      }
      if (method == Method::kQuad) {
        ASSERT_EQ(seed.channel[ch].second, wrapped(second));
        ASSERT_EQ(seed.channel[ch].curvature,
                  wrapped(second - 2 * first + Polynomial(s, method, x - 1, y)));
      }
      in_range += first >= kLeastAcc && first <= kMostAcc;
    }
  }
  EXPECT_EQ(SpanSetup::kContract.max_error_ulp, 0) << "a value in S9.26 equals its wrapped form";
  EXPECT_GT(in_range, 400000) << "the search is blind: half of the surfaces must not wrap";
}

// A x^2 + D x + F with A = 1/16 code, D = -4095/16: both products reach a million codes at x =
// 4095.
TEST(SpanSetup, WrapOfIntermediateTermsIsHarmless) {
  std::mt19937 random(1);
  for (const int x : {4095, -4095}) {
    Dut::Work work = RandomWork(Method::kQuad, 1, random);
    work.spans.resize(1);
    work.spans[0].y = work.triangles[0].origin_y;
    work.spans[0].last = true;
    work.spans[0].x = x > 0 ? 4095 : 0;
    work.triangles[0].origin_x = x > 0 ? 0 : 4095;
    for (Surface& s : work.triangles[0].surface) {
      s = {};
      s.a = IntensityAcc::FromRaw(kOneCode / 16);
      s.d = IntensityAcc::FromRaw(-x * kOneCode / 16);
      s.f = IntensityAcc::FromRaw(77 * kOneCode);
    }
    Dut rtl;
    const Dut::Result result = rtl.Run(work, AlwaysFlows());
    ExpectSeeds(work, result);
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_EQ(result.seeds[0].seed.channel[0].first.raw(), 77 * kOneCode);
    EXPECT_EQ(result.seeds[0].seed.channel[2].difference.raw(), (x + 1) * kOneCode / 16);
  }
}

TEST(SpanSetup, SpanWaitsForItsTriangle) {
  for (const Method method : kSurfaceMethods) {
    std::mt19937 random(1);
    const Dut::Work work = RandomWork(method, 8, random);
    const Dut::Flows flows = {FlowPattern::Recorded("00000000000000000001"), FlowPattern::Always(),
                              FlowPattern::Always()};
    Dut rtl;
    ExpectRun(&rtl, work, flows);
    const Dut::Result again = rtl.Run(work, flows);
    ASSERT_EQ(again.failure, "");
    EXPECT_EQ(again.spans[0], 19) << "taken together with its triangle, not before";
  }
}

TEST(SpanSetup, TriangleLeavesWithItsLastSpan) {
  for (const Method method : kSurfaceMethods) {
    std::mt19937 random(1);
    Dut::Work work = RandomWork(method, 8, random);
    work.spans.resize(8);
    for (size_t k = 0; k < 8; ++k) {
      work.spans[k].last = true;
      work.spans[k].y = work.triangles[k].origin_y;
    }
    Dut rtl;
    ExpectRun(&rtl, work, AlwaysFlows());
    const Dut::Result again = rtl.Run(work, AlwaysFlows());
    ASSERT_EQ(again.failure, "");
    EXPECT_EQ(again.triangles[1], SpanSetup::Steps(method, 0));
  }
}

// One span waits as a seed, one for its last sum, one for its product, one in its steps: the fifth
// stays outside.
TEST(SpanSetup, StalledWalkerBlocksSeedSumAndSteps) {
  for (const Method method : kSurfaceMethods) {
    std::mt19937 random(1);
    const Dut::Work work = RandomWork(method, 8, random);
    Dut::Flows flows = AlwaysFlows();
    flows.seed = FlowPattern::Recorded(std::string(50, '0') + "1");
    Dut rtl;
    ExpectRun(&rtl, work, flows);
    const Dut::Result again = rtl.Run(work, flows);
    ASSERT_EQ(again.failure, "");
    EXPECT_LT(again.spans[3], 50);
    EXPECT_GE(again.spans[4], 50);
  }
}

TEST(SpanSetup, NextFrameSwitchesMethodWithoutReset) {
  std::mt19937 random(1);
  Dut rtl;
  for (int frame = 0; frame < 60; ++frame) {
    SCOPED_TRACE("frame " + std::to_string(frame));
    const Method method = kSurfaceMethods[random() % kSurfaceMethods.size()];
    ExpectRun(&rtl, RandomWork(method, 1 + static_cast<int>(random() % 3), random), AlwaysFlows());
  }
}

// Auto: a method for each triangle, some without a highlight, all of them in the pipeline at once.
TEST(SpanSetup, EachTriangleHasItsMethod) {
  std::mt19937 random(5);
  for (const Flow seed : kFlows) {
    SCOPED_TRACE("seeds " + NameOf(seed));
    Dut::Work work = RandomWork(Method::kQuad, kTriangles, random);
    for (size_t t = 0; t < work.triangles.size(); ++t) {
      Choice choice = ChoiceOf(kSurfaceMethods[random() % kSurfaceMethods.size()]);
      choice.dark = random() % 3 == 0;
      choice.channels = static_cast<uint8_t>(random() % 8);
      work.choices.push_back(choice);
    }
    Dut rtl;
    ExpectRun(&rtl, work, {FlowPattern::Always(), FlowPattern::Always(), PatternOf(seed, 4)});
  }
}

TEST(SpanSetup, ResetDropsEverything) {
  std::mt19937 random(1);
  Dut rtl;
  EXPECT_NE(rtl.Run(RandomWork(Method::kQuad, 9, random), AlwaysFlows(), 20).failure, "");
  rtl.Reset();
  ExpectRun(&rtl, RandomWork(Method::kGouraud, 9, random), AlwaysFlows());
}

TEST(SpanSetupDeathTest, SpanOfNoPixelsStopsTheSimulation) {
  std::mt19937 random(1);
  Dut::Work work = RandomWork(Method::kFlat, 1, random);
  work.spans[0].length = 0;
  EXPECT_EXIT(Dut().Run(work, AlwaysFlows()), testing::KilledBySignal(SIGABRT), "");
}

TEST(SpanSetupDeathTest, SpanAboveTheOneBeforeStopsTheSimulation) {
  Dut::Work work = RowByRow(Method::kQuad, 2);
  work.spans[1].y = work.spans[0].y - 1;
  EXPECT_EXIT(Dut().Run(work, AlwaysFlows()), testing::KilledBySignal(SIGABRT), "");
}

}  // namespace
}  // namespace shading
