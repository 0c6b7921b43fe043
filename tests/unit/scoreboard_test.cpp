// SPDX-License-Identifier: Apache-2.0
#include "tb/scoreboard/scoreboard.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "model/raster/front_end.h"
#include "tb/rtl_shading_unit.h"
#include "tb/scoreboard/mismatch_report.h"
#include "tb/stimulus/random_triangles.h"
#include "tests/unit/one_span.h"

namespace shading {
namespace {

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
