// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/aniso_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "tb/dut/aniso_footprint_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/footprint/footprint_bench.h"

namespace shading {
namespace {

using Dut = tb::AnisoFootprintDut;
using Dut4 = tb::AnisoFootprint4Dut;
constexpr int kSpans = 4000;

using Flows = std::tuple<Flow, Flow>;
class AnisoFootprintFlow : public testing::TestWithParam<Flows> {
 protected:
  template <typename Build>
  void ExpectSame(uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<typename Build::Span> spans;
    for (int i = 0; i < kSpans; ++i) spans.push_back(RandomSpan<Build>(random));
    const FlowPattern source = PatternOf(std::get<0>(GetParam()), 1);
    const FlowPattern sink = PatternOf(std::get<1>(GetParam()), 2);
    Build rtl;
    FootprintExpectation<Build> model;
    model.Expect(spans, rtl.Run(spans, source, sink), sink);
    EXPECT_GT(model.taken(), kSpans);
    EXPECT_GT(model.excluded(), kSpans) << "nothing is excluded: the test is blind";
  }
};

TEST_P(AnisoFootprintFlow, RtlMatchesModel) { ExpectSame<Dut>(1); }
TEST_P(AnisoFootprintFlow, RtlOfFourLanesMatchesModel) { ExpectSame<Dut4>(2); }

constexpr auto kFlows = {Flow::kAlways, Flow::kOneInFour, Flow::kRandom};
INSTANTIATE_TEST_SUITE_P(AllFlows, AnisoFootprintFlow,
                         testing::Combine(testing::ValuesIn(kFlows), testing::ValuesIn(kFlows)),
                         [](const auto& flow) {
                           return "Source" + NameOf(std::get<0>(flow.param)) + "Sink" +
                                  NameOf(std::get<1>(flow.param));
                         });

// Spans of single pixels, all patterns: a sample every cycle, none between.
template <typename Build>
void ExpectTiming() {
  EXPECT_EQ(Build::kLatency, AnisoFootprint::kContract.latency_cycles);
  std::mt19937 random(3);
  std::vector<typename Build::Span> spans;
  for (int i = 0; i < 64; ++i) {
    spans.push_back(RandomSpan<Build>(random));
    spans.back().footprint.pattern = static_cast<FootprintPattern>(i % kFootprintPatterns);
    spans.back().groups.resize(1);
  }
  const FlowPattern always = FlowPattern::Always();
  Build rtl;
  const auto result = rtl.Run(spans, always, always);
  ASSERT_EQ(result.failure, "");
  ASSERT_EQ(result.samples.size(), 64u / 4 * (1 + 2 + 4 + 7));
  for (size_t i = 0; i < result.samples.size(); ++i) {  // loaded in cycle 0
    EXPECT_EQ(
        result.samples[i].cycle,
        Build::kLatency + static_cast<int64_t>(i) * AnisoFootprint::kContract.interval_cycles);
  }
}

TEST(AnisoFootprint, ContractMatchesRtl) {
  ExpectTiming<Dut>();
  ExpectTiming<Dut4>();
}

// Of what is in range, samples are sums without error, whatever the pixel.
TEST(AnisoFootprint, ModelWithinErrorBound) {
  std::mt19937 random(4);
  for (int i = 0; i < 20000; ++i) {
    Footprint footprint;
    footprint.pattern = FootprintPattern::kEight;
    std::array<Quantity, 3> centre;
    for (size_t c = 0; c < 3; ++c) {
      centre[c] = Quantity::Round(std::ldexp(static_cast<double>(random()), -32));
      for (auto& offset : footprint.offset) {
        offset.normal[c] = Quantity::Round(std::ldexp(static_cast<double>(random()), -33));
      }
    }
    AnisoFootprint model(footprint, {}, 0, 1);
    for (int s = 0; s < kMostSamples; ++s) {
      const FootprintSample sample = model.Next(s, centre);
      ASSERT_TRUE(sample.live);
      for (size_t c = 0; c < 3; ++c) {
        double ideal = centre[c].ToReal();
        if (s > 0) {
          const double offset =
              footprint.offset[static_cast<size_t>((s - 1) / 2)].normal[c].ToReal();
          ideal += s % 2 ? offset : -offset;
        }
        ASSERT_EQ(sample.normal[c].ToReal(), ideal);
      }
    }
  }
}

Quantity Real(double value) { return Quantity::Round(value); }
Margin Side(double value) { return Margin::Round(value); }

TEST(AnisoFootprint, SumsSaturate) {
  Footprint footprint;
  footprint.pattern = FootprintPattern::kTwo;
  footprint.offset[0].normal = {Real(1.5), Real(-1.5), Real(0)};
  AnisoFootprint model(footprint, {}, 0, 1);
  const std::array<Quantity, 3> centre = {Real(1), Real(1), Real(1)};
  const FootprintSample plus = model.Next(0, centre), minus = model.Next(1, centre);
  EXPECT_EQ(plus.normal[0].raw(), (int64_t{1} << 39) - 1);
  EXPECT_EQ(plus.normal[1], Real(-0.5));
  EXPECT_EQ(minus.normal[0], Real(-0.5));
  EXPECT_EQ(minus.normal[1].raw(), (int64_t{1} << 39) - 1);
  EXPECT_EQ(minus.normal[2], Real(1));
}

// A border belongs to the triangle; all samples outside: the centre in place of the last.
TEST(AnisoFootprint, OutsideIsExcludedButNeverThePixel) {
  Footprint footprint;
  footprint.pattern = FootprintPattern::kTwo;
  footprint.offset[0].normal = {Real(0.25), Real(0), Real(0)};
  footprint.offset[0].margin = {Side(0.25), Side(-0.25), Side(0)};
  const std::array<Quantity, 3> centre = {Real(0), Real(0), Real(1)};
  {
    AnisoFootprint model(footprint, {Side(0.25), Side(0.25), Side(0)}, 0, 1);
    EXPECT_TRUE(model.Next(0, centre).live);
    EXPECT_TRUE(model.Next(1, centre).live);
  }
  {
    AnisoFootprint model(footprint, {Side(0.125), Side(0.5), Side(0)}, 0, 1);
    EXPECT_TRUE(model.Next(0, centre).live);
    EXPECT_FALSE(model.Next(1, centre).live);
  }
  AnisoFootprint model(footprint, {Side(0.125), Side(0.125), Side(0)}, 0, 1);
  EXPECT_FALSE(model.Next(0, centre).live);
  const FootprintSample last = model.Next(1, centre);
  EXPECT_TRUE(last.live);
  EXPECT_EQ(last.normal, centre);
}

TEST(AnisoFootprint, ResetAndClear) {
  std::mt19937 random(5);
  std::vector<Dut::Span> spans;
  for (int i = 0; i < 20; ++i) spans.push_back(RandomSpan<Dut>(random));
  const FlowPattern always = FlowPattern::Always();
  for (int stop = 1; stop < 40; ++stop) {
    Dut rtl;
    rtl.Run(spans, always, always, stop);
    rtl.Reset();
    FootprintExpectation<Dut> model;
    ASSERT_NO_FATAL_FAILURE(model.Expect(spans, rtl.Run(spans, always, always), always));
    rtl.Clear();
    FootprintExpectation<Dut> again;
    ASSERT_NO_FATAL_FAILURE(again.Expect(spans, rtl.Run(spans, always, always), always));
  }
}

}  // namespace
}  // namespace shading
