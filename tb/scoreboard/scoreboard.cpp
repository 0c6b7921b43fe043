// SPDX-License-Identifier: Apache-2.0
#include "tb/scoreboard/scoreboard.h"

#include <algorithm>

namespace shading::tb {

Scoreboard::Scoreboard(const FrameWork& work, int lanes, const FlowPattern& source,
                       const FlowPattern& sink)
    : work_(work), model_(work, lanes, source, sink), pixels_(kMaxScreen) {
  verdicts_.pixels_expected = work.pixels;
  verdicts_.spans_expected = static_cast<int64_t>(work.spans.size());
}

bool Scoreboard::Consume(const TimedPixel* pixels, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    if (index_ == length_) {
      if (next_span_ == work_.spans.size()) {
        ++verdicts_.pixel_mismatches;
        Keep(pixels[i], true);
        return false;
      }
      NextSpan();
    }
    const bool pixel_differs = pixels[i].pixel != pixels_[static_cast<size_t>(index_)];
    const bool cycle_differs = pixels[i].cycle != model_.CycleOf(timing_, index_);
    if (pixel_differs || cycle_differs) {
      verdicts_.pixel_mismatches += pixel_differs;
      cycle_differs_ |= cycle_differs;
      Keep(pixels[i], false);
    }
    ++verdicts_.pixels_compared;
    if (++index_ == length_) {
      ++verdicts_.spans_compared;
      verdicts_.cycle_mismatches += cycle_differs_;
      if (records_) {
        const Counters& now = model_.counters();
        records_->push_back({timing_, pixels[i].cycle, now.normalised - before_.normalised,
                             now.skipped - before_.skipped});
      }
    }
  }
  return true;
}

void Scoreboard::NextSpan() {
  if (!triangle_open_) model_.Triangle(work_.triangles[next_triangle_++]);
  const SpanCommand& span = work_.spans[next_span_++];
  before_ = model_.counters();
  timing_ = model_.Span(span, pixels_.data());
  triangle_open_ = !span.last;
  index_ = 0;
  length_ = span.length;
  cycle_differs_ = false;
}

void Scoreboard::Keep(const TimedPixel& actual, bool unexpected) {
  if (verdicts_.mismatches.size() == kKept) return;
  Mismatch m;
  m.actual = actual;
  m.unexpected = unexpected;
  if (next_span_ > 0) {
    m.span = static_cast<int64_t>(next_span_) - 1;
    m.triangle = work_.packet[next_triangle_ - 1];
    m.command = work_.spans[next_span_ - 1];
    m.seed = model_.seed();
    std::copy_n(work_.triangles[next_triangle_ - 1].surface.begin(), kChannels, m.surface);
  }
  if (!unexpected) {
    m.index = index_;
    m.expected = {pixels_[static_cast<size_t>(index_)], model_.CycleOf(timing_, index_)};
  }
  verdicts_.mismatches.push_back(m);
}

const Verdicts& Scoreboard::Finish(const RtlResult& result) {
  verdicts_.failure = result.failure;
  // The unit is empty in the cycle after its last pixel; an empty frame in the one after its start.
  const int64_t cycles = next_span_ > 0 ? timing_.last_left + 1 : 1;
  if (verdicts_.failure.empty() && !result.finished) verdicts_.failure = "the RTL did not run";
  if (verdicts_.failure.empty() && result.cycles != cycles) {
    verdicts_.failure = "the RTL was empty in cycle " + std::to_string(result.cycles) +
                        ", the model in cycle " + std::to_string(cycles);
  }
  verdicts_.counters_match = result.counters == model_.counters();
  return verdicts_;
}

}  // namespace shading::tb
