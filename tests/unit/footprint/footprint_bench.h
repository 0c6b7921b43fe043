// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "model/flow_pattern.h"
#include "model/footprint/aniso_footprint.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {

// Near 0, where the sign is decided; or anything.
inline Margin RandomMargin(std::mt19937& random) {
  switch (random() % 4) {
    case 0: return Margin::Wrap(static_cast<int64_t>(random() % 5) - 2);
    case 1: return Margin::Wrap(Bits64(random));
    default: return Margin::Wrap(AnyOctave(30, random));
  }
}

inline Footprint RandomFootprint(std::mt19937& random) {
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
class FootprintExpectation {
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

}  // namespace shading
