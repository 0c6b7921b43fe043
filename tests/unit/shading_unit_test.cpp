// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "model/raster/front_end.h"
#include "tb/rtl_shading_unit.h"
#include "tb/scoreboard/scoreboard.h"
#include "tb/stimulus/random_triangles.h"
#include "tests/unit/one_span.h"
#include "tests/unit/shading_unit_timing.h"

namespace shading {
namespace {

constexpr int kFrames = 12;
constexpr int kTriangles = 300;

struct Flow {
  const char* name;
  FlowPattern source, sink;
};

std::vector<Flow> Flows() {
  return {{"always", FlowPattern::Always(), FlowPattern::Always()},
          {"sink one in four", FlowPattern::Always(), FlowPattern::OneInFour()},
          {"sink random", FlowPattern::Always(), FlowPattern::Random(3)},
          {"source one in four", FlowPattern::OneInFour(), FlowPattern::Always()},
          {"both random", FlowPattern::Random(5), FlowPattern::Random(6)},
          {"recorded", FlowPattern::Recorded("1110001"), FlowPattern::Recorded("00000000001111")}};
}

tb::Verdicts Compare(tb::RtlShadingUnit* rtl, const FrameWork& work, const Flow& flow,
                     int lanes = 1) {
  tb::Scoreboard scoreboard(work, lanes, flow.source, flow.sink);
  const tb::RtlResult result = rtl->Run(work, flow.source, flow.sink, &scoreboard, {});
  return scoreboard.Finish(result);
}

void ExpectGood(const tb::Verdicts& v, const std::string& where) {
  EXPECT_TRUE(v.Good()) << where << ": " << v.failure << " pixels " << v.pixels_compared << " of "
                        << v.pixels_expected << ", " << v.pixel_mismatches << " differ; spans "
                        << v.spans_compared << " of " << v.spans_expected << ", "
                        << v.cycle_mismatches << " in other cycles; counters " << v.counters_match;
}

// Both kinds of light, so that Phong's R.V is met.
TriangleList Triangles(uint32_t seed) {
  TriangleList list = tb::RandomTriangles(seed, kTriangles);
  if (seed % 2 == 0) list.frame.lighting = Lighting::kPhong;
  return list;
}

// From none to 4 %.
FrontEndOptions ToleranceOf(uint32_t seed) {
  FrontEndOptions options;
  options.tolerance = Tolerance::Round(std::array<double, 4>{0.5, 2.55, 0, 10.2}[seed % 4]);
  return options;
}

class ShadingUnitMethod : public testing::TestWithParam<Method> {
 protected:
  void ExpectSame(tb::RtlShadingUnit* rtl, int lanes, uint32_t frames, int64_t least_pixels) {
    int64_t pixels = 0;
    for (const Flow& flow : Flows()) {
      for (uint32_t seed = 1; seed <= frames; ++seed) {
        const FrameWork work = FrontEnd::Run(Triangles(seed), GetParam(), ToleranceOf(seed));
        const tb::Verdicts verdicts = Compare(rtl, work, flow, lanes);
        ExpectGood(verdicts, std::string(flow.name) + ", seed " + std::to_string(seed));
        pixels += verdicts.pixels_compared;
      }
    }
    EXPECT_GT(pixels, least_pixels);
  }
};

TEST_P(ShadingUnitMethod, RtlMatchesModel) {
  const bool slow = LightsPixels(GetParam()) || IsQuadRow(GetParam());
  ExpectSame(tb::RtlShadingUnit::Create(GetParam()).get(), 1, slow ? 4 : kFrames,
             slow ? 300000 : 1000000);
}

TEST_P(ShadingUnitMethod, FourLanesMatchModel) {
  ExpectSame(tb::RtlShadingUnit::CreateAll(kMaxLanes).get(), kMaxLanes, 2, 150000);
}

// Each span is its own triangle, so that triangle hand-over is in the path.
TEST_P(ShadingUnitMethod, NoBubbleBetweenSpansAsLongAsTheirSetup) {
  const Method method = GetParam();
  const int length = HidingLength(method);
  FrameWork work;
  work.method = method;
  work.materials.emplace_back();
  work.limits.emplace_back();
  for (int k = 0; k < 100; ++k) {
    work.triangles.emplace_back();
    work.triangles.back().origin_y = k;
    work.packet.push_back(static_cast<uint32_t>(k));
    work.spans.push_back({0, k, length, {}, true});
    work.pixels += length;
  }
  const Flow flow = Flows().front();
  tb::Scoreboard scoreboard(work, 1, flow.source, flow.sink);
  const auto rtl = tb::RtlShadingUnit::Create(method);
  const tb::RtlResult result = rtl->Run(work, flow.source, flow.sink, &scoreboard, {});
  ExpectGood(scoreboard.Finish(result), "short spans");
  // The spans follow each other; what remains is the latency of the first one.
  EXPECT_EQ(result.counters.setup, Latency(method));
  // choice_stage holds the first triangle for a cycle.
  EXPECT_EQ(result.cycles, work.pixels + result.counters.setup + 2 + (method == Method::kAuto));
}

// Paper 003's row of 16 pixels: cycles from the first pixel of a row to that of the next.
TEST_P(ShadingUnitMethod, RowsOf16PixelsFollowEvery16CyclesWithFourLanesEvery4) {
  const Method method = GetParam();
  const int least = InterpolatesNormals(method) ? HidingLength(method) : 0;
  constexpr int kRows = 10, kLength = 16;
  FrameWork work;
  work.method = method;
  work.triangles.emplace_back();
  work.packet.push_back(0);
  for (int y = 0; y < kRows; ++y) work.spans.push_back({0, y, kLength, {}, y == kRows - 1});
  work.pixels = kRows * kLength;
  struct FirstPixels : tb::PixelConsumer {
    std::vector<int64_t> cycles;
    bool Consume(const TimedPixel* pixels, size_t count) override {
      for (size_t i = 0; i < count; ++i) {
        if (pixels[i].pixel.x == 0) cycles.push_back(pixels[i].cycle);
      }
      return true;
    }
  };
  for (const int lanes : {1, kMaxLanes}) {
    FirstPixels first;
    const auto rtl =
        lanes == 1 ? tb::RtlShadingUnit::Create(method) : tb::RtlShadingUnit::CreateAll(lanes);
    rtl->Run(work, FlowPattern::Always(), FlowPattern::Always(), &first, {});
    ASSERT_EQ(first.cycles.size(), static_cast<size_t>(kRows));
    for (size_t y = 1; y < kRows; ++y) {
      EXPECT_EQ(first.cycles[y] - first.cycles[y - 1], std::max(kLength / lanes, least))
          << lanes << " lanes, row " << y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShadingUnitMethod, testing::ValuesIn(kAllMethods),
                         [](const auto& test) {
                           std::string name(Name(test.param));
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// Frame after frame through one instance, so that the methods change without a reset.
TEST(ShadingUnit, BuildWithAllMethodsChangesMethodBetweenFrames) {
  uint32_t seed = 70;
  for (const int lanes : {1, kMaxLanes}) {
    const auto all = tb::RtlShadingUnit::CreateAll(lanes);
    for (const Flow& flow : Flows()) {
      // From one kind to the other, and from every method to another than the next.
      for (size_t k = 0; k < kAllMethods.size(); ++k) {
        const Method method = kAllMethods[7 * k % kAllMethods.size()];
        const FrameWork work = FrontEnd::Run(tb::RandomTriangles(++seed, 60), method);
        ExpectGood(Compare(all.get(), work, flow, lanes), flow.name);
      }
    }
  }
}

TEST(ShadingUnit, ContractMatchesRtl) {
  const FrameWork work = OneSpan(Method::kQuad, 100);
  const Flow flow = Flows().front();
  struct Recorder : tb::PixelConsumer {
    std::vector<int64_t> cycles;
    bool Consume(const TimedPixel* pixels, size_t count) override {
      for (size_t i = 0; i < count; ++i) cycles.push_back(pixels[i].cycle);
      return true;
    }
  } recorder;
  tb::RtlShadingUnit::Create(Method::kQuad)->Run(work, flow.source, flow.sink, &recorder, {});
  ASSERT_EQ(recorder.cycles.size(), 100u);
  // The span is taken in cycle 1, the first in which it may be on offer.
  EXPECT_EQ(recorder.cycles.front() - 1, ShadingUnit::kContract.latency_cycles);
  EXPECT_EQ(recorder.cycles.back() - recorder.cycles.front(),
            99 * ShadingUnit::kContract.interval_cycles);
}

// Spans within the tolerance are never normalised; the counts of a frame are those of its spans.
TEST(ShadingUnit, AdaptiveCountsNormalisations) {
  const TriangleList list = tb::RandomTriangles(2, kTriangles);
  const Flow flow = Flows().front();
  const auto rtl = tb::RtlShadingUnit::Create(Method::kAdaptive);
  int64_t before = INT64_MAX;
  for (const double tolerance : {0.0, 0.5, 2.55, 10.2}) {
    FrontEndOptions options;
    options.tolerance = Tolerance::Round(tolerance);
    const FrameWork work = FrontEnd::Run(list, Method::kAdaptive, options);
    int64_t normalised = 0, skipped = 0;
    for (size_t k = 0, t = 0; k < work.spans.size(); t += work.spans[k++].last) {
      const SpanCommand& span = work.spans[k];
      AdaptiveNormalizer model(AdaptiveKind::kSphere, span.normal, span.length,
                               work.triangles[t].limit);
      AdaptiveSegment segment;
      while (model.Next(&segment)) continue;
      normalised += model.normalisations();
      skipped += model.skipped();
    }
    tb::Scoreboard scoreboard(work, 1, flow.source, flow.sink);
    tb::RtlResult result = rtl->Run(work, flow.source, flow.sink, &scoreboard, {});
    EXPECT_EQ(result.counters.normalised, normalised);
    EXPECT_EQ(result.counters.skipped, skipped);
    EXPECT_LT(normalised, before) << tolerance;
    before = normalised;
    ExpectGood(scoreboard.Finish(result), "adaptive");
    ++result.counters.normalised;
    EXPECT_FALSE(scoreboard.Finish(result).Good()) << "a count that is wrong";
  }
}

TEST(ShadingUnit, FrameWithoutTriangles) {
  FrameWork work;
  work.method = Method::kQuad;
  const auto rtl = tb::RtlShadingUnit::Create(Method::kQuad);
  ExpectGood(Compare(rtl.get(), work, Flows().front()), "empty frame");
}

}  // namespace
}  // namespace shading
