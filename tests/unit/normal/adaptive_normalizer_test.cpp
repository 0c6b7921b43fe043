// SPDX-License-Identifier: Apache-2.0
#include "model/normal/adaptive_normalizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "model/normal/adaptive_normalizer_table.h"
#include "model/normal/linear_recurrence.h"
#include "model/normal/phong_direct.h"
#include "tests/unit/normal/adaptive_accuracy.h"
#include "tests/unit/normal/adaptive_bench.h"

namespace shading {
namespace {

using Dut = tb::AdaptiveNormalizerDut;
using Dut4 = tb::AdaptiveNormalizer4Dut;

constexpr auto kFlows = {Flow::kAlways, Flow::kOneInFour, Flow::kRandom};
constexpr auto kKinds = {AdaptiveKind::kSphere, AdaptiveKind::kExtended, AdaptiveKind::kChord};
constexpr AngleLimit kLargeLimit = AngleLimit::FromRaw(AngleLimit::kMaxRaw);

std::string NameOf(AdaptiveKind kind) {
  constexpr std::array<const char*, 3> kNames = {"Sphere", "Extended", "Chord"};
  return kNames[static_cast<size_t>(kind)];
}

template <typename Build>
void ExpectSame(AdaptiveKind kind, const std::vector<typename Build::Span>& spans, Flow source,
                Flow sink) {
  const FlowPattern offers = PatternOf(source, 1), takes = PatternOf(sink, 2);
  Build rtl;
  AdaptiveExpectation<Build> expectation(kind, offers, takes);
  ASSERT_NO_FATAL_FAILURE(expectation.Expect(spans, rtl.Run(kind, spans, offers, takes)));
}

using Case = std::tuple<AdaptiveKind, Flow, Flow>;
class AdaptiveNormalizerFlow : public testing::TestWithParam<Case> {
 protected:
  // Short spans, then some up to the longest.
  template <typename Build>
  void ExpectEveryPixel() {
    const auto [kind, source, sink] = GetParam();
    std::mt19937 random(1);
    for (const auto& [most, count] : {std::pair<int, int>{40, 1500}, {4096, 30}}) {
      std::vector<typename Build::Span> spans;
      for (int i = 0; i < count; ++i) spans.push_back(RandomAdaptiveSpan<Build>(most, random));
      ASSERT_NO_FATAL_FAILURE(ExpectSame<Build>(kind, spans, source, sink));
    }
  }
};
TEST_P(AdaptiveNormalizerFlow, RtlMatchesModel) { ExpectEveryPixel<Dut>(); }
TEST_P(AdaptiveNormalizerFlow, FourLanesMatchModel) { ExpectEveryPixel<Dut4>(); }

INSTANTIATE_TEST_SUITE_P(AllFlows, AdaptiveNormalizerFlow,
                         testing::Combine(testing::ValuesIn(kKinds), testing::ValuesIn(kFlows),
                                          testing::ValuesIn(kFlows)),
                         [](const auto& param) {
                           return NameOf(std::get<0>(param.param)) + "Spans" +
                                  NameOf(std::get<1>(param.param)) + "Pixels" +
                                  NameOf(std::get<2>(param.param));
                         });

template <typename Build>
typename Build::Span SpanPins(Real turn, int length, AngleLimit limit, std::mt19937& random) {
  typename Build::Span span = {};
  span.run.length = length;
  span.normal = SpanOf(RandomPlane(random), turn, length).normal;
  span.limit = limit;
  return span;
}

template <typename Build>
void ExpectTiming() {
  std::mt19937 random(1);
  const std::vector<typename Build::Span> spans(20, SpanPins<Build>(0.1L, 1, kLargeLimit, random));
  Build rtl;
  const auto result =
      rtl.Run(AdaptiveKind::kSphere, spans, FlowPattern::Always(), FlowPattern::Always());
  ASSERT_EQ(result.failure, "");
  for (size_t k = 0; k < spans.size(); ++k) {
    EXPECT_EQ(result.groups[k].cycle - result.spans[k], Build::kLatency);
    if (k > 0) {
      EXPECT_EQ(result.spans[k] - result.spans[k - 1], Build::kInterval);
    }
  }
  EXPECT_EQ(Build::kLatency, AdaptiveNormalizer::kContract.latency_cycles);
  EXPECT_EQ(Build::kInterval, AdaptiveNormalizer::kContract.interval_cycles);
}

TEST(AdaptiveNormalizer, ContractMatchesRtl) {
  ExpectTiming<Dut>();
  ExpectTiming<Dut4>();
}

// Rows of 500 pixels that turn 30 degrees, for (N.H)^32 within 1 code: 32 parts each. The groups
// follow without a gap; with four lanes a border inside a group costs a cycle.
template <typename Build>
int64_t CyclesOf(size_t rows) {
  std::mt19937 random(1);
  const std::vector<typename Build::Span> spans(
      rows, SpanPins<Build>(30 * kDegree, 500, LimitOf(1, 32), random));
  Build rtl;
  const auto result =
      rtl.Run(AdaptiveKind::kSphere, spans, FlowPattern::Always(), FlowPattern::Always());
  EXPECT_EQ(result.failure, "");
  return result.groups.back().cycle - result.groups.front().cycle + 1;
}
TEST(AdaptiveNormalizer, FullRateBehindLongRows) {
  int borders = 0;  // inside a group of four
  for (int part = 1; part < 32; ++part) borders += (part * 499 + 31) / 32 % 4 != 0;
  EXPECT_EQ(borders, 21);
  EXPECT_EQ(CyclesOf<Dut>(8), 8 * 500);
  EXPECT_EQ(CyclesOf<Dut4>(8), 8 * (125 + borders));
}

// Where no span needs a division, no product of the division moves and no normalisation starts; the
// printed extension normalises its end all the same, and a chord both ends.
TEST(AdaptiveNormalizer, OneSegmentMovesNoNormalisation) {
  std::mt19937 random(1);
  constexpr int kSpans = 300;
  const FlowPattern flow = FlowPattern::Random(3);
  std::vector<Dut::Span> spans;
  for (int i = 0; i < kSpans; ++i) {
    const int length = RandomAdaptiveLength(500, random);
    spans.push_back(
        SpanPins<Dut>(RandomTurnUpTo(40 * kDegree, random), length, kLargeLimit, random));
  }
  const auto run = [&](AdaptiveKind kind) {
    Dut rtl;
    return rtl.Run(kind, spans, flow, flow);
  };
  const auto sphere = run(AdaptiveKind::kSphere);
  ASSERT_EQ(sphere.failure, "");
  EXPECT_EQ(sphere.normaliser_starts, 0);
  EXPECT_EQ(sphere.middle_changes, 0);
  EXPECT_EQ(run(AdaptiveKind::kExtended).normaliser_starts, kSpans);
  EXPECT_EQ(run(AdaptiveKind::kChord).normaliser_starts, 2 * kSpans);
  for (Dut::Span& span : spans) span.limit = {};
  const auto divided = run(AdaptiveKind::kSphere);
  ASSERT_EQ(divided.failure, "");
  EXPECT_EQ(divided.normaliser_starts, 0);
  EXPECT_GT(divided.middle_changes, kSpans);
}

// Wherever it stops: in the set-up, the division, the queue, or with half a group gathered.
TEST(AdaptiveNormalizer, ResetEmptiesIt) {
  std::mt19937 random(1);
  const FlowPattern always = FlowPattern::Always();
  Dut4 rtl;
  for (const AdaptiveKind kind : kKinds) {
    for (int64_t stop = 1; stop < 150; ++stop) {
      std::vector<Dut4::Span> spans;
      for (int i = 0; i < 20; ++i) spans.push_back(RandomAdaptiveSpan<Dut4>(40, random));
      rtl.Run(kind, spans, always, always, stop);
      rtl.Reset();
      spans.resize(2);
      AdaptiveExpectation<Dut4> expectation(kind, always, always);
      ASSERT_NO_FATAL_FAILURE(expectation.Expect(spans, rtl.Run(kind, spans, always, always)));
    }
  }
}

// The guarantee: within the tolerance of slerp, whatever the span. Those of the front end turn up
// to 90 degrees; the unit is right up to 120.
constexpr Real kWideBound = 0.036L;

TEST(AdaptiveNormalizer, ModelWithinErrorBound) {
  std::mt19937 random(1);
  Real worst = -1;
  for (const Real tolerance : {0.5L, 1.0L, 2.55L, 10.2L}) {
    for (const int n : {1, 8, 32, 128, 256}) {
      const AngleLimit limit = LimitOf(tolerance, n);
      for (const Real most : {90 * kDegree, 120 * kDegree}) {
        const Found found = SearchWorst(AdaptiveKind::kSphere, limit, n, most, 120, random);
        SCOPED_TRACE("n = " + std::to_string(n) + ": " + Text(found));
        const Real bound =
            most > kQuarterTurn ? kWideBound : AdaptiveNormalizer::kContract.max_error_ulp;
        EXPECT_LE(found.error, tolerance + bound);
        EXPECT_GT(found.error, 0.97L * tolerance) << "the search is blind";
        worst = std::max(worst, found.error - tolerance);
      }
    }
  }
  RecordProperty("worst_codes_beyond_tolerance", std::to_string(worst));
  EXPECT_GT(worst, 0);
}

// Spans of a few pixels that turn far: parts shorter than a pixel, more normalisations than pixels.
TEST(AdaptiveNormalizer, SteepShortSpansKeepTheTolerance) {
  std::mt19937 random(1);
  int most = 0;
  for (int i = 0; i < 4000; ++i) {
    const int length = 3 + static_cast<int>(random() % 14);
    const Real turn = 90 * kDegree - RandomTurnUpTo(60 * kDegree, random);
    const IdealSpan ideal(RandomPlane(random), turn, length, false);
    const AngleLimit limit = LimitOf(0.5L, 256);
    ASSERT_LE(WorstPixel(AdaptiveKind::kSphere, ideal, limit, 256), 0.51L) << length;
    const auto model =
        VisitPixels(AdaptiveKind::kSphere, ideal.span, limit, [](int, const PixelNormal&) {});
    most = std::max(most, model.normalisations());
    ASSERT_LE(model.normalisations(), model.levels() * length);
    if (model.normalisations() >= length) {
      ASSERT_EQ(model.skipped(), 0);
    }
  }
  EXPECT_GT(most, 50);
}

// What the paper's extension to a power of 2 costs, at its worst length: half a step above one. Its
// end lies on the extended chord, the nodes on the sphere.
TEST(AdaptiveNormalizer, ExtensionMissesTheEnd) {
  std::mt19937 random(1);
  const auto miss = [&](Real degrees, int length, int n) {
    const IdealSpan ideal(RandomPlane(random), degrees * kDegree, length, false);
    return WorstPixel(AdaptiveKind::kExtended, ideal, LimitOf(0.5L, n), n);
  };
  for (const auto& [degrees, diffuse, specular] :
       {std::tuple<Real, Real, Real>{15, 2.06L, 14.2L}, {30, 13.5L, 87.4L}, {60, 65.6L, 251.5L}}) {
    EXPECT_NEAR(static_cast<double>(miss(degrees, 130, 1) / diffuse), 1, 0.02);
    EXPECT_NEAR(static_cast<double>(miss(degrees, 130, 128) / specular), 1, 0.02);
    EXPECT_LE(miss(degrees, 129, 1), 0.51L) << "a power of 2";
    EXPECT_LE(miss(degrees, 129, 128), 0.51L) << "a power of 2";
  }
}

// Every border of parts of a pixel each is Phong's normal there.
TEST(AdaptiveNormalizer, ChordPointsArePhongs) {
  std::mt19937 random(1);
  for (int i = 0; i < 300; ++i) {
    const int steps = 1 << (random() % 9);
    const SpanCommand span =
        SpanOf(RandomPlane(random), RandomTurnUpTo(120 * kDegree, random), steps + 1);
    VisitPixels(AdaptiveKind::kChord, span, {}, [&](int pixel, const PixelNormal& normal) {
      std::array<Quantity, 3> line;
      for (size_t c = 0; c < 3; ++c) {
        const int64_t a = span.normal[0][c].raw(), b = span.normal[1][c].raw();
        line[c] = Quantity::Wrap((a * (steps - pixel) + b * pixel) * 256 / steps);
      }
      const PixelNormal phong = PhongDirect::Of(line);
      for (size_t c = 0; c < 3; ++c) ASSERT_LE(std::abs(normal[c].raw() - phong[c].raw()), 1);
    });
  }
}

// Against Phong's normals the chord keeps (N.H)^n up to 90 degrees; N.L loses up to 1.8 codes
// beyond a large tolerance, because pixels of a part that is 32 degrees wide are not where its
// points are.
TEST(AdaptiveNormalizer, ChordAgainstPhong) {
  std::mt19937 random(1);
  for (const Real tolerance : {0.5L, 1.0L, 10.2L}) {
    for (const int n : {1, 32, 128}) {
      const Found found =
          SearchWorst(AdaptiveKind::kChord, LimitOf(tolerance, n), n, 90 * kDegree, 80, random);
      EXPECT_LE(found.error, tolerance + (n == 1 ? 1.8L : 0.01L)) << n << ": " << Text(found);
    }
  }
}

}  // namespace
}  // namespace shading
