// SPDX-License-Identifier: Apache-2.0
#include "model/raster/span_binder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "tb/dut/span_binder_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/raster/span_stimulus.h"

namespace shading {
namespace {

constexpr int kTriangles = 3000;
using Dut = tb::SpanBinderDut;

// Triangles of one to six spans, half of them of one; materials and normals of any bits.
Dut::Work WorkOf(int triangles, uint32_t seed) {
  std::mt19937 random(seed);
  const tb::SpanSetupDut::Work plain = RandomWork(Method::kQuad, triangles, random);
  Dut::Work work{plain.triangles, plain.spans};
  for (TriangleState& triangle : work.triangles) {
    triangle.material = static_cast<int>(random() % 256);
    triangle.limit = AngleLimit::FromRaw(static_cast<int64_t>(random() & AngleLimit::kMaxRaw));
    triangle.footprint.pattern = static_cast<FootprintPattern>(random() % kFootprintPatterns);
    for (FootprintOffset& offset : triangle.footprint.offset) {
      for (Margin& margin : offset.margin) margin = Margin::Wrap(random());
      for (Quantity& normal : offset.normal) normal = Quantity::Wrap(int64_t{random()} << 8);
    }
    for (Margin& margin : triangle.footprint.margin_dx) margin = Margin::Wrap(random());
  }
  for (SpanCommand& span : work.spans) {
    for (Margin& margin : span.margin) margin = Margin::Wrap(random());
    for (SpanNormal& normal : span.normal) {
      for (auto& component : normal) component = SpanNormalComponent::Wrap(random());
    }
  }
  return work;
}

void ExpectRuns(const Dut::Work& work, const Dut::Result& result) {
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.runs.size(), work.spans.size());
  size_t triangle = 0;
  for (size_t i = 0; i < work.spans.size(); ++i) {
    const SpanSeed expected = SpanBinder::Bind(work.triangles[triangle], work.spans[i]);
    const SpanSeed& run = result.runs[i].run;
    ASSERT_EQ(run.x, expected.x) << "span " << i;
    ASSERT_EQ(run.y, expected.y) << "span " << i;
    ASSERT_EQ(run.length, expected.length) << "span " << i;
    ASSERT_EQ(run.z.raw(), expected.z.raw()) << "span " << i;
    ASSERT_EQ(run.dz_dx.raw(), expected.dz_dx.raw()) << "span " << i;
    ASSERT_EQ(run.material, expected.material) << "span " << i;
    ASSERT_EQ(result.runs[i].normal, work.spans[i].normal) << "span " << i;
    ASSERT_EQ(result.runs[i].limit, work.triangles[triangle].limit) << "span " << i;
    ASSERT_EQ(result.runs[i].choice, Dut::ChoiceOf(triangle)) << "span " << i;
    ASSERT_EQ(result.runs[i].kind, Dut::KindOf(triangle)) << "span " << i;
    ASSERT_EQ(result.runs[i].footprint, Dut::FootprintBits(work.triangles[triangle], work.spans[i]))
        << "span " << i;
    if (work.spans[i].last) ++triangle;
  }
}

// Exact cycles of every triangle and span, and with them that no span passes before its triangle;
// busy_o from the cycle after a triangle was taken to the one in which its last span passes.
void ExpectCycles(const Dut::Work& work, const Dut::Flows& flows, const Dut::Result& result) {
  SpanBinder binder;
  std::vector<bool> busy(result.busy.size());
  int64_t taken = binder.TakeTriangle(flows.triangle.Next(0)), passed = -1;
  size_t triangle = 0;
  for (size_t i = 0; i < work.spans.size(); ++i) {
    ASSERT_EQ(result.triangles[triangle], taken) << "triangle " << triangle;
    const int64_t offered = binder.OfferRun(flows.span.Next(passed + 1));
    ASSERT_EQ(result.runs[i].offered, offered) << "span " << i;
    passed = flows.run.Next(offered);
    ASSERT_EQ(result.spans[i], passed) << "span " << i;
    ASSERT_EQ(result.runs[i].taken, passed) << "span " << i;
    binder.PassSpan(passed, work.spans[i].last);
    if (!work.spans[i].last) continue;
    for (int64_t c = taken + 1; c <= passed; ++c) busy[static_cast<size_t>(c)] = true;
    ++triangle;
    taken = binder.TakeTriangle(flows.triangle.Next(taken + 1));
  }
  EXPECT_EQ(result.triangles.size(), work.triangles.size());
  EXPECT_EQ(result.busy, busy);
}

void ExpectRun(const Dut::Work& work, const Dut::Flows& flows) {
  Dut rtl;
  const Dut::Result result = rtl.Run(work, flows);
  ASSERT_NO_FATAL_FAILURE(ExpectRuns(work, result));
  ExpectCycles(work, flows, result);
}

Dut::Flows AlwaysFlows() {
  return {FlowPattern::Always(), FlowPattern::Always(), FlowPattern::Always()};
}

using Flows = std::tuple<Flow, Flow, Flow>;
class SpanBinderFlow : public testing::TestWithParam<Flows> {};

TEST_P(SpanBinderFlow, RtlMatchesModel) {
  const auto [triangle, span, run] = GetParam();
  ExpectRun(WorkOf(kTriangles, 4), {PatternOf(triangle, 1), PatternOf(span, 2), PatternOf(run, 3)});
}

constexpr auto kFlows = {Flow::kAlways, Flow::kOneInFour, Flow::kRandom};
INSTANTIATE_TEST_SUITE_P(AllFlows, SpanBinderFlow,
                         testing::Combine(testing::ValuesIn(kFlows), testing::ValuesIn(kFlows),
                                          testing::ValuesIn(kFlows)),
                         [](const auto& flow) {
                           return "Triangle" + NameOf(std::get<0>(flow.param)) + "Span" +
                                  NameOf(std::get<1>(flow.param)) + "Run" +
                                  NameOf(std::get<2>(flow.param));
                         });

TEST(SpanBinder, ContractMatchesRtl) {
  EXPECT_EQ(Dut::kLatency, SpanBinder::kContract.latency_cycles);
  const Dut::Work work = WorkOf(50, 1);
  Dut rtl;
  const Dut::Result result = rtl.Run(work, AlwaysFlows());
  ASSERT_EQ(result.failure, "");
  for (size_t i = 0; i < work.spans.size(); ++i) {
    EXPECT_EQ(result.runs[i].taken - result.spans[i], SpanBinder::kContract.latency_cycles);
    if (i == 0) continue;
    EXPECT_EQ(result.spans[i] - result.spans[i - 1], SpanBinder::kContract.interval_cycles);
  }
}

// Every field of a run is one of the span or of the triangle, bit for bit.
TEST(SpanBinder, ModelWithinErrorBound) {
  const Dut::Work work = WorkOf(1000, 1);
  for (size_t i = 0; i < work.triangles.size(); ++i) {
    const TriangleState& triangle = work.triangles[i];
    const SpanCommand& span = work.spans[i];
    const SpanSeed run = SpanBinder::Bind(triangle, span);
    ASSERT_TRUE(run.x == span.x && run.y == span.y && run.length == span.length);
    ASSERT_TRUE(run.z == span.z && run.dz_dx == triangle.dz_dx);
    ASSERT_EQ(run.material, triangle.material);
  }
  EXPECT_EQ(SpanBinder::kContract.max_error_ulp, 0);
}

// A triangle of one span passes through in one cycle and is never inside.
TEST(SpanBinder, TriangleAndItsOnlySpanInTheSameCycle) {
  Dut::Work work = WorkOf(64, 1);
  work.spans.resize(64);
  for (SpanCommand& span : work.spans) span.last = true;
  Dut rtl;
  const Dut::Result result = rtl.Run(work, AlwaysFlows());
  ExpectRuns(work, result);
  for (size_t i = 0; i < 64; ++i) {
    EXPECT_EQ(result.triangles[i], static_cast<int64_t>(i));
    EXPECT_EQ(result.spans[i], static_cast<int64_t>(i));
  }
  EXPECT_EQ(std::count(result.busy.begin(), result.busy.end(), true), 0);
}

// The triangle waits inside, so the next one may enter only when its last span passes.
TEST(SpanBinder, NextTriangleEntersWithTheLastSpan) {
  Dut::Work work = WorkOf(8, 1);
  work.spans.resize(8);
  for (SpanCommand& span : work.spans) span.last = true;
  Dut::Flows flows = AlwaysFlows();
  flows.run = FlowPattern::Recorded("0001");
  Dut rtl;
  const Dut::Result result = rtl.Run(work, flows);
  ExpectRuns(work, result);
  EXPECT_EQ(result.triangles[0], 0);
  for (size_t i = 1; i < 8; ++i) EXPECT_EQ(result.triangles[i], result.spans[i - 1]);
}

TEST(SpanBinder, SpanWaitsForItsTriangle) {
  Dut::Flows flows = AlwaysFlows();
  flows.triangle = FlowPattern::Recorded("00000000000000000001");
  ExpectRun(WorkOf(8, 1), flows);
}

TEST(SpanBinder, ResetDropsTheTriangle) {
  Dut::Flows blocked = AlwaysFlows();
  blocked.run = FlowPattern::Recorded("0000000001");
  Dut rtl;
  EXPECT_NE(rtl.Run(WorkOf(1, 1), blocked, 4).failure, "") << "a triangle is inside";
  rtl.Reset();
  const Dut::Work work = WorkOf(4, 2);
  Dut::Flows late = AlwaysFlows();
  late.triangle = FlowPattern::OneInFour();
  const Dut::Result result = rtl.Run(work, late);
  ASSERT_NO_FATAL_FAILURE(ExpectRuns(work, result));
  ExpectCycles(work, late, result);
}

}  // namespace
}  // namespace shading
