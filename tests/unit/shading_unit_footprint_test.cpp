// SPDX-License-Identifier: Apache-2.0
//
// The shading unit with footprints: cycles of a pixel, and what was counted of its samples.
#include <gtest/gtest.h>

#include "model/footprint/footprint_setup.h"
#include "model/raster/front_end.h"
#include "tb/rtl_shading_unit.h"
#include "tb/scoreboard/scoreboard.h"
#include "tb/stimulus/random_triangles.h"

namespace shading {
namespace {

constexpr FootprintPattern kPatterns[] = {FootprintPattern::kCentre, FootprintPattern::kTwo,
                                          FootprintPattern::kFour, FootprintPattern::kEight};

// Spans of one triangle, all of one pattern.
FrameWork Rows(FootprintPattern pattern, int rows, int length) {
  FrameWork work;
  work.method = Method::kFootprint;
  work.materials.emplace_back();
  work.triangles.emplace_back();
  work.triangles[0].footprint.pattern = pattern;
  work.packet.push_back(0);
  for (int y = 0; y < rows; ++y) {
    work.spans.push_back({0, y, length, {}, y + 1 == rows});
    work.pixels += length;
  }
  return work;
}

struct Checked {
  tb::RtlResult rtl;
  bool good;
};

Checked Compare(const FrameWork& work, int lanes, const FlowPattern& sink) {
  const FlowPattern source = FlowPattern::Always();
  tb::Scoreboard scoreboard(work, lanes, source, sink);
  const auto unit = lanes == 1 ? tb::RtlShadingUnit::Create(work.method)
                               : tb::RtlShadingUnit::CreateAll(lanes);
  Checked checked;
  checked.rtl = unit->Run(work, source, sink, &scoreboard, {});
  checked.good = scoreboard.Finish(checked.rtl).Good();
  return checked;
}

TEST(ShadingUnitFootprint, PixelTakesACycleASample) {
  for (const int lanes : {1, kMaxLanes}) {
    for (const FootprintPattern pattern : kPatterns) {
      constexpr int kRows = 5, kLength = 64;
      const Checked checked = Compare(Rows(pattern, kRows, kLength), lanes, FlowPattern::Always());
      EXPECT_TRUE(checked.good);
      const int samples = SampleCount(pattern);
      // The span is taken in cycle 1; the unit is empty in the cycle after the last pixel.
      const int64_t groups = kRows * kLength / lanes;
      EXPECT_EQ(checked.rtl.cycles, NormalSetup::Latency(lanes) + 32 + groups * samples + 2);
      EXPECT_EQ(checked.rtl.counters.samples_taken, kRows * kLength * samples);
      EXPECT_EQ(checked.rtl.counters.samples_excluded, 0);
      EXPECT_EQ(checked.rtl.counters.samples_saved, kRows * kLength * (kMostSamples - samples));
    }
  }
}

TEST(ShadingUnitFootprint, SamplesAreCounted) {
  const FrameWork work =
      FrontEnd::Run(tb::RandomTriangles(4, 300), Method::kFootprintPaper, FrontEndOptions());
  const FlowPattern sink = FlowPattern::Random(3);
  tb::Scoreboard scoreboard(work, 1, FlowPattern::Always(), sink);
  tb::RtlResult result = tb::RtlShadingUnit::Create(Method::kFootprintPaper)
                             ->Run(work, FlowPattern::Always(), sink, &scoreboard, {});
  EXPECT_TRUE(scoreboard.Finish(result).Good());
  const Counters& counters = result.counters;
  EXPECT_GT(counters.samples_excluded, 0) << "nothing to see";
  EXPECT_EQ(counters.samples_taken + counters.samples_excluded + counters.samples_saved,
            kMostSamples * work.pixels);
  for (int64_t Counters::*count :
       {&Counters::samples_taken, &Counters::samples_excluded, &Counters::samples_saved}) {
    tb::RtlResult wrong = result;
    ++(wrong.counters.*count);
    EXPECT_FALSE(scoreboard.Finish(wrong).Good());
  }
}

}  // namespace
}  // namespace shading
