// SPDX-License-Identifier: Apache-2.0
#include "model/shading_clock.h"

#include <algorithm>
#include <utility>

#include "model/raster/span_setup.h"

namespace shading {

ShadingClock::ShadingClock(Method method, FlowPattern source, FlowPattern sink)
    : steps_(SpanSetup::Steps(method)), source_(std::move(source)), sink_(std::move(sink)) {}

void ShadingClock::Triangle() {
  constexpr int64_t kLead = FlowPattern::kTriangleLead;
  const int64_t offered = source_.Next(triangle_taken_ + 1 + kLead) - kLead;
  triangle_taken_ = std::max(offered, triangle_released_);
}

SpanTiming ShadingClock::Span(int length, bool last) {
  SpanTiming timing;
  const int64_t offered = source_.Next(span_taken_ + 1);
  timing.accepted = std::max({offered, triangle_taken_, last_step_});

  // The first step shares its cycle with the last sum of the span before, which may be waiting for
  // the seed register.
  const int64_t first_step = std::max(timing.accepted + 1, sum_);
  last_step_ = first_step + steps_ - 1;
  sum_ = std::max(last_step_ + 1, seed_taken_);
  seed_taken_ = std::max(sum_ + 1, last_left_);

  timing.first_valid = seed_taken_ + 1;
  timing.sink_rank = sink_.always() ? timing.first_valid : sink_.Rank(timing.first_valid);
  timing.last_left = sink_.always() ? timing.first_valid + length - 1
                                    : sink_.Select(timing.sink_rank + length - 1);
  timing.setup = timing.first_valid - 1 - std::max(timing.accepted, last_left_);
  timing.stall = timing.last_left - timing.first_valid + 1 - length;

  span_taken_ = timing.accepted;
  last_left_ = timing.last_left;
  if (last) triangle_released_ = last_step_;
  return timing;
}

}  // namespace shading
