// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "model/normal/adaptive_clock.h"
#include "tb/dut/adaptive_normalizer_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/adaptive_stimulus.h"

namespace shading {

template <typename Build>
typename Build::Span RandomAdaptiveSpan(int most_length, std::mt19937& random) {
  typename Build::Span span;
  span.run.length = RandomAdaptiveLength(most_length, random);
  const auto wide = [&] {
    return DepthAcc::Wrap(static_cast<int64_t>(random()) << 8 | (random() & 255));
  };
  span.run.x = static_cast<int>(random() % 4096);
  span.run.y = static_cast<int>(random() % 4096);
  span.run.z = wide();
  span.run.dz_dx = wide();
  span.run.material = static_cast<int>(random() % 256);
  span.limit = RandomLimit(random);
  const Real turn = RandomTurnUpTo(random() % 2 ? kQuarterTurn : 120 * kDegree, random);
  span.normal = SpanOf(RandomPlane(random), turn, 2).normal;
  if (random() % 16 == 0) {  // anything
    for (SpanNormal& normal : span.normal) {
      for (SpanNormalComponent& c : normal) {
        c = SpanNormalComponent::Wrap(static_cast<int64_t>(random()));
      }
    }
  }
  return span;
}

// What the model says about every pixel and every cycle, in order.
template <typename Build>
class AdaptiveExpectation {
 public:
  using Result = typename Build::Result;
  AdaptiveExpectation(AdaptiveKind kind, const FlowPattern& spans, const FlowPattern& pixels)
      : kind_(kind), spans_(spans), pixels_(pixels) {}

  void Expect(const std::vector<typename Build::Span>& spans, const Result& rtl) {
    ASSERT_EQ(rtl.failure, "");
    ASSERT_EQ(rtl.spans.size(), spans.size());
    ASSERT_EQ(rtl.starts.size(), spans.size());
    ASSERT_EQ(rtl.counts.size(), spans.size());
    for (size_t k = 0; k < spans.size(); ++k) {
      SCOPED_TRACE("span " + std::to_string(k) + " of " + std::to_string(spans[k].run.length));
      ASSERT_NO_FATAL_FAILURE(Span(k, spans[k], rtl));
    }
    ASSERT_EQ(group_, rtl.groups.size());
  }

 private:
  void Span(size_t k, const typename Build::Span& span, const Result& rtl) {
    AdaptiveNormalizer model(kind_, span.normal, span.run.length, span.limit);
    const int64_t taken = std::max(spans_.Next(next_), clock_.free());
    next_ = taken + 1;
    ASSERT_EQ(rtl.spans[k], taken);
    clock_.TakeSpan(taken, model.setup_cycles());
    AdaptiveSegment segment;
    AdaptiveClock::Timing timing = {};
    for (bool first = true; model.Next(&segment); first = false) {
      leaves_.clear();
      timing = clock_.Segment(segment, [&](int64_t from, int64_t groups) {
        const int64_t rank = pixels_.Rank(from);
        for (int64_t i = 0; i < groups; ++i) leaves_.push_back(pixels_.Select(rank + i));
        return leaves_.back();
      });
      if (first) {
        ASSERT_EQ(rtl.starts[k].cycle, timing.loaded);
        ASSERT_EQ(rtl.starts[k].run, Build::RunBits(span));
      }
      ASSERT_NO_FATAL_FAILURE(Segment(segment, rtl));
    }
    ASSERT_EQ(rtl.counts[k].cycle, timing.issued);
    ASSERT_EQ(rtl.counts[k].normalised, model.normalisations());
    ASSERT_EQ(rtl.counts[k].skipped, model.skipped());
  }

  void Segment(const AdaptiveSegment& segment, const Result& rtl) {
    std::array<Quantity, 3> value = segment.first;
    size_t left = 0;
    for (int i = 0; i < segment.count; ++i) {
      ASSERT_LT(group_, rtl.groups.size());
      const auto& group = rtl.groups[group_];
      const PixelNormal normal = AdaptiveNormalizer::Rounded(value);
      for (size_t c = 0; c < 3; ++c) {
        ASSERT_EQ(group.normal[lane_][c].raw(), normal[c].raw()) << "pixel " << i;
        value[c] = Quantity::Wrap(value[c].raw() + segment.difference[c].raw());
      }
      const bool last = segment.last && i + 1 == segment.count;
      if (++lane_ < Build::kLaneCount && !last) continue;
      ASSERT_EQ(group.mask, (1u << lane_) - 1);
      ASSERT_EQ(group.last, last);
      ASSERT_LT(left, leaves_.size());
      ASSERT_EQ(group.cycle, leaves_[left++]) << "pixel " << i;
      lane_ = 0;
      ++group_;
    }
    ASSERT_EQ(left, leaves_.size());
  }

  AdaptiveKind kind_;
  const FlowPattern &spans_, &pixels_;
  AdaptiveClock clock_{Build::kLaneCount};
  std::vector<int64_t> leaves_;
  int64_t next_ = 0;
  size_t group_ = 0, lane_ = 0;
};

}  // namespace shading
