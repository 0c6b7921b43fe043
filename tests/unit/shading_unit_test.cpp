// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "model/normal/normal_shader.h"
#include "model/raster/front_end.h"
#include "tb/rtl_shading_unit.h"
#include "tb/scoreboard/mismatch_report.h"
#include "tb/scoreboard/scoreboard.h"
#include "tb/stimulus/random_triangles.h"

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

// slerp_direct_setup stands behind normal_setup.
int ArcLatency(Method method) {
  return method == Method::kSlerpDirect ? SlerpDirectSetup::kContract.latency_cycles : 0;
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

// Cycles from a span to its first pixel, the unit idle.
int Latency(Method method) {
  const int light = PixelLight::kContract.latency_cycles + PixelQueue::kContract.latency_cycles;
  if (IsAdaptive(method)) {
    return AdaptiveNormalizer::kContract.latency_cycles - 1 + CosineLatency(method) + light +
           (method == Method::kAdaptivePaper ? AdaptiveNormalizer::kExtend
            : method == Method::kAdaptiveChord
                ? AdaptiveNormalizer::kChordEnds + AdaptiveNormalizer::kChordTest
                : 0);
  }
  if (!InterpolatesNormals(method)) {
    return SpanSetup::Steps(method, 0) + 2 + (LightsPixels(method) ? light : 0);
  }
  return NormalSetup::Latency(1) + ArcLatency(method) + CosineLatency(method) + light;
}

// Each span is its own triangle, so that triangle hand-over is in the path.
// The shortest spans that hide the set-up of the next.
int HidingLength(Method method) {
  switch (method) {
    case Method::kAdaptive: return AdaptiveNormalizer::kSetup;
    case Method::kAdaptivePaper: return AdaptiveNormalizer::kSetup + AdaptiveNormalizer::kExtend;
    case Method::kAdaptiveChord:
      return 1 + AdaptiveNormalizer::kChordEnds + AdaptiveNormalizer::kChordTest;
    default: return InterpolatesNormals(method) ? NormalSetup::kSteps : SpanSetup::Steps(method, 0);
  }
}

TEST_P(ShadingUnitMethod, NoBubbleBetweenSpansAsLongAsTheirSetup) {
  const Method method = GetParam();
  const int length = HidingLength(method);
  FrameWork work;
  work.method = method;
  work.materials.emplace_back();
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
  EXPECT_EQ(result.cycles, work.pixels + result.counters.setup + 2);
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

FrameWork OneSpan(Method method, int length) {
  FrameWork work;
  work.method = method;
  work.triangles.emplace_back();
  work.packet.push_back(0);
  work.spans.push_back({0, 0, length, {}, true});
  work.pixels = length;
  return work;
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

TEST(Scoreboard, FailsWhenPixelsAreMissing) {
  const FrameWork work = OneSpan(Method::kQuad, 100);
  tb::Scoreboard scoreboard(work, 1, FlowPattern::Always(), FlowPattern::Always());
  EXPECT_FALSE(scoreboard.Finish({}).Good());
}

TEST(Scoreboard, FailsOnEachFieldAndOnTheCycle) {
  const FrameWork work = OneSpan(Method::kFlat, 3);
  struct Recorder : tb::PixelConsumer {
    std::vector<TimedPixel> pixels;
    bool Consume(const TimedPixel* p, size_t count) override {
      pixels.insert(pixels.end(), p, p + count);
      return true;
    }
  } good;
  const auto always = FlowPattern::Always();
  const tb::RtlResult result =
      tb::RtlShadingUnit::Create(Method::kFlat)->Run(work, always, always, &good, {});
  const auto verdict = [&](const std::vector<TimedPixel>& pixels) {
    tb::Scoreboard scoreboard(work, 1, always, always);
    scoreboard.Consume(pixels.data(), pixels.size());
    return scoreboard.Finish(result);
  };
  ASSERT_TRUE(verdict(good.pixels).Good());
  const auto broken = [&](auto change) {
    auto pixels = good.pixels;
    change(pixels[1]);
    return verdict(pixels);
  };
  EXPECT_EQ(broken([](TimedPixel& p) { ++p.pixel.x; }).pixel_mismatches, 1);
  EXPECT_EQ(broken([](TimedPixel& p) { ++p.pixel.y; }).pixel_mismatches, 1);
  EXPECT_EQ(broken([](TimedPixel& p) { ++p.pixel.z; }).pixel_mismatches, 1);
  EXPECT_EQ(broken([](TimedPixel& p) { ++p.pixel.r; }).pixel_mismatches, 1);
  EXPECT_EQ(broken([](TimedPixel& p) { ++p.pixel.g; }).pixel_mismatches, 1);
  EXPECT_EQ(broken([](TimedPixel& p) { ++p.pixel.b; }).pixel_mismatches, 1);
  EXPECT_EQ(broken([](TimedPixel& p) { p.pixel.last = 1; }).pixel_mismatches, 1);
  EXPECT_EQ(broken([](TimedPixel& p) { ++p.cycle; }).cycle_mismatches, 1);
  auto more = good.pixels;
  more.push_back(more.back());
  EXPECT_FALSE(verdict(more).Good());
}

TEST(MismatchReport, NamesTheFirstDifferenceAndWritesItsWaveform) {
  const FrameWork work = FrontEnd::Run(tb::RandomTriangles(4, 200), Method::kQuad);
  const auto always = FlowPattern::Always();
  // The RTL is right, so the fault is put into what the scoreboard sees of it.
  struct Tamper : tb::PixelConsumer {
    explicit Tamper(tb::Scoreboard* to) : scoreboard(to) {}
    bool Consume(const TimedPixel* pixels, size_t count) override {
      std::vector<TimedPixel> copy(pixels, pixels + count);
      if (!done) copy[40].pixel.g ^= 1;
      done = true;
      return scoreboard->Consume(copy.data(), count);
    }
    tb::Scoreboard* scoreboard;
    bool done = false;
  };
  tb::Scoreboard scoreboard(work, 1, always, always);
  Tamper tamper(&scoreboard);
  const auto result =
      tb::RtlShadingUnit::Create(Method::kQuad)->Run(work, always, always, &tamper, {});
  const tb::Verdicts verdicts = scoreboard.Finish(result);
  ASSERT_FALSE(verdicts.Good());
  ASSERT_EQ(verdicts.pixel_mismatches, 1);

  const std::string wave = testing::TempDir() + "mismatch_report.fst";
  std::remove(wave.c_str());
  const std::string text = tb::ReportMismatch(work, 1, verdicts, always, always, wave);
  for (const char* word : {"quad triangle", "span", "pixel", "green: RTL", "coefficients",
                           "seed in the RTL", "seed in the model", "waveform"}) {
    EXPECT_NE(text.find(word), std::string::npos) << word << " in\n" << text;
  }
  EXPECT_TRUE(std::ifstream(wave).good());
  EXPECT_TRUE(std::ifstream(testing::TempDir() + "mismatch_report.gtkw").good());
  // Operands of both sides are those of the same span.
  const auto seed_at = text.find("seed in the RTL: ") + 17;
  const auto model_at = text.find("seed in the model: ") + 19;
  EXPECT_EQ(text.substr(seed_at, 60), text.substr(model_at, 60));

  const std::string elsewhere =
      tb::ReportMismatch(work, 1, verdicts, always, always, "/no/such/folder/wave.fst");
  EXPECT_NE(elsewhere.find("green: RTL"), std::string::npos);
  EXPECT_NE(elsewhere.find("no waveform"), std::string::npos);
}

TEST(Scoreboard, FailsWhenTheUnitIsEmptyInAnotherCycle) {
  const FrameWork work = OneSpan(Method::kFlat, 3);
  const auto always = FlowPattern::Always();
  tb::Scoreboard scoreboard(work, 1, always, always);
  tb::RtlResult result =
      tb::RtlShadingUnit::Create(Method::kFlat)->Run(work, always, always, &scoreboard, {});
  ++result.cycles;
  EXPECT_FALSE(scoreboard.Finish(result).Good());
}

}  // namespace
}  // namespace shading
