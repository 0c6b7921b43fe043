// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/aniso_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <random>
#include <tuple>
#include <vector>

#include "tb/dut/aniso_footprint_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {
namespace {

using Dut = tb::AnisoFootprintDut;
using Dut4 = tb::AnisoFootprint4Dut;
constexpr int kSpans = 4000;

// Near 0, where the sign is decided; or anything.
Margin RandomMargin(std::mt19937& random) {
  switch (random() % 4) {
    case 0: return Margin::Wrap(static_cast<int64_t>(random() % 5) - 2);
    case 1: return Margin::Wrap(Bits64(random));
    default: return Margin::Wrap(AnyOctave(30, random));
  }
}

Footprint RandomFootprint(std::mt19937& random) {
  Footprint footprint;
  footprint.pattern = static_cast<FootprintPattern>(random() % kFootprintPatterns);
  const bool excludes = random() % 4 != 0;
  for (FootprintOffset& offset : footprint.offset) {
    for (Quantity& value : offset.normal) value = AnyQuantity(random);
    for (Margin& value : offset.margin) {
      if (excludes) value = RandomMargin(random);
    }
  }
  for (Margin& value : footprint.margin_dx) {
    if (excludes) value = Margin::Wrap(AnyOctave(26, random));
  }
  return footprint;
}

template <typename Build>
typename Build::Span RandomSpan(std::mt19937& random) {
  typename Build::Span span;
  span.footprint = RandomFootprint(random);
  for (Margin& value : span.first) value = RandomMargin(random);
  span.groups.resize(1 + random() % (random() % 8 ? 4 : 24));
  for (auto& group : span.groups) {
    group.mask = (1u << Build::kLaneCount) - 1;
    for (auto& lanes : group.normal) {
      for (Quantity& value : lanes) value = AnyQuantity(random);
    }
  }
  span.groups.back().mask >>= random() % Build::kLaneCount;
  return span;
}

// What the model says of every sample and its cycle.
template <typename Build>
class Expectation {
 public:
  void Expect(const std::vector<typename Build::Span>& spans, const typename Build::Result& rtl,
              const FlowPattern& sink) {
    ASSERT_EQ(rtl.failure, "");
    for (const auto& span : spans) ASSERT_NO_FATAL_FAILURE(Span(span, rtl, sink));
    ASSERT_EQ(group_, rtl.enters.size());
    ASSERT_EQ(sample_, rtl.samples.size());
    EXPECT_EQ(rtl.counters.taken, static_cast<uint32_t>(taken_));
    EXPECT_EQ(rtl.counters.excluded, static_cast<uint32_t>(excluded_));
    EXPECT_EQ(rtl.counters.saved, static_cast<uint32_t>(saved_));
    EXPECT_EQ(taken_ + excluded_ + saved_, kMostSamples * pixels_);
  }
  int64_t taken() const { return taken_; }
  int64_t excluded() const { return excluded_; }

 private:
  void Span(const typename Build::Span& span, const typename Build::Result& rtl,
            const FlowPattern& sink) {
    std::vector<AnisoFootprint> lanes;
    for (size_t j = 0; j < Build::kLaneCount; ++j) {
      lanes.emplace_back(span.footprint, span.first, static_cast<int>(j),
                         static_cast<int>(Build::kLaneCount));
    }
    const int count = SampleCount(span.footprint.pattern);
    for (const auto& group : span.groups) {
      ASSERT_LT(group_, rtl.enters.size());
      const int64_t offered = rtl.offers[group_], enters = sink.Next(offered + count - 1);
      ASSERT_EQ(rtl.enters[group_], enters) << "group " << group_;
      ++group_;
      for (int i = 0; i < count; ++i, ++sample_) {
        ASSERT_LT(sample_, rtl.samples.size());
        const int64_t turn = i + 1 < count ? offered + i : enters;
        ASSERT_EQ(rtl.samples[sample_].cycle, turn + AnisoFootprint::kSampleLatency);
        ASSERT_NO_FATAL_FAILURE(Sample(i, i + 1 == count, group, rtl.samples[sample_], &lanes));
      }
      for (auto& lane : lanes) lane.Step();
      for (size_t j = 0; j < lanes.size(); ++j) {
        if (group.mask >> j & 1) saved_ += kMostSamples - count, ++pixels_;
      }
    }
  }

  void Sample(int i, bool last, const typename Build::Group& group,
              const typename Build::Sample& rtl, std::vector<AnisoFootprint>* lanes) {
    ASSERT_EQ(rtl.first, i == 0);
    ASSERT_EQ(rtl.last, last);
    for (size_t j = 0; j < lanes->size(); ++j) {
      const FootprintSample model =
          (*lanes)[j].Next(i, {group.normal[0][j], group.normal[1][j], group.normal[2][j]});
      ASSERT_EQ((rtl.live >> j & 1) != 0, model.live) << "sample " << sample_;
      ASSERT_EQ(rtl.twice, model.weight == 2);
      for (size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(rtl.normal[j][c].raw(), model.normal[c].raw()) << "sample " << sample_;
      }
      if (group.mask >> j & 1) ++(model.live ? taken_ : excluded_);
    }
  }

  size_t group_ = 0, sample_ = 0;
  int64_t taken_ = 0, excluded_ = 0, saved_ = 0, pixels_ = 0;
};

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
    Expectation<Build> model;
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
    EXPECT_EQ(result.samples[i].cycle, Build::kLatency + static_cast<int64_t>(i) *
                                                             AnisoFootprint::kContract.interval_cycles);
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
          const double offset = footprint.offset[static_cast<size_t>((s - 1) / 2)].normal[c].ToReal();
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
    Expectation<Dut> model;
    ASSERT_NO_FATAL_FAILURE(model.Expect(spans, rtl.Run(spans, always, always), always));
    rtl.Clear();
    Expectation<Dut> again;
    ASSERT_NO_FATAL_FAILURE(again.Expect(spans, rtl.Run(spans, always, always), always));
  }
}

}  // namespace
}  // namespace shading
