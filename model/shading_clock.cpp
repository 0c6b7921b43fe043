// SPDX-License-Identifier: Apache-2.0
#include "model/shading_clock.h"

#include <algorithm>
#include <utility>

#include "model/footprint/footprint_mean.h"
#include "model/light/pixel_light.h"
#include "model/normal/normal_shader.h"
#include "model/raster/span_setup.h"

namespace shading {
namespace {

// A group leaves pixel_walker in some cycle and is on offer so many cycles later.
constexpr int64_t LightLatency(Method method) {
  return CosineLatency(method == Method::kAuto ? Method::kPhongDuff : method) +
         PixelLight::kContract.latency_cycles +
         (IsFootprint(method) ? FootprintMean::kContract.latency_cycles : 0) +
         PixelQueue::kContract.latency_cycles;
}

constexpr bool QueueOutlastsLight() {
  for (const Method method : kAllMethods) {
    if (LightLatency(method) >= PixelQueue::kDepth) return false;
  }
  return true;
}
static_assert(QueueOutlastsLight(), "else a span would have bubbles, and Leave() be wrong");

}  // namespace

ShadingClock::ShadingClock(Method method, int lanes, FlowPattern source, FlowPattern sink)
    : auto_(method == Method::kAuto),
      method_(method),
      lanes_(lanes),
      source_(std::move(source)),
      sink_(std::move(sink)),
      normal_setup_(NormalSetup::StageCount(lanes)),
      arc_setup_(SlerpDirectSetup::kStages),
      adaptive_(lanes) {
  if (IsAdaptive(method) || IsFootprint(method)) left_.reserve(kMaxScreen);
}

void ShadingClock::Triangle(Method method) {
  constexpr int64_t kLead = FlowPattern::kTriangleLead;
  const int64_t offered = source_.Next(triangle_taken_ + 1 + kLead) - kLead;
  if (!auto_) {
    triangle_taken_ = binder().TakeTriangle(offered);
    return;
  }
  method_ = method;
  triangle_taken_ = std::max(offered, stage_left_);
  stage_left_ = binder().TakeTriangle(std::max(triangle_taken_, span_taken_) + 1);
}

int64_t ShadingClock::OfferSurfaceSeed(int64_t offered, int rows, bool last) {
  span_taken_ = std::max(binder().OfferRun(offered), last_step_);
  // A sum that waits for the seed register holds every span behind it: first that of the span
  // before the last one, and when this has moved on, that of the last one.
  int64_t first_step = std::max(span_taken_ + 1, older_sum_);
  if (first_step > finish_) first_step = std::max(first_step, sum_);
  const int more = SpanSetup::Steps(method_, rows) - 1;
  last_step_ = more == 0 ? first_step : std::max(first_step + 1, sum_) + more - 1;
  finish_ = std::max(last_step_ + 1, sum_);
  older_sum_ = sum_;
  sum_ = std::max(finish_ + 1, surface_seed_taken_);
  binder().PassSpan(last_step_, last);
  if (!auto_) return sum_ + 1;
  surface_seed_taken_ = seed_queue_.Take(sum_ + 1);
  return surface_seed_taken_ + 1;
}

int64_t ShadingClock::OfferNormalSeed(int64_t offered, bool last) {
  span_taken_ = std::max(binder().OfferRun(offered), normal_setup_.free());
  binder().PassSpan(span_taken_, last);
  const int64_t seed_offered = normal_setup_.Offer(span_taken_, normal_seed_taken_);
  if (method_ != Method::kSlerpDirect) return seed_offered;
  normal_seed_taken_ = std::max(seed_offered, arc_setup_.free());
  return arc_setup_.Offer(normal_seed_taken_, seed_taken_);
}

// Groups on offer to the light from cycle `offered` on enter as the queue has room. Room for a
// later group never comes so late that the groups on offer would break off, since the light takes
// fewer cycles than the queue has places.
ShadingClock::Lit ShadingClock::Light(int64_t offered, int64_t groups, int64_t latency) {
  const int64_t first = queue_.groups();
  Lit lit;
  lit.first_entered = std::max(offered, queue_.RoomFor(first, sink_) + 1);
  lit.first_valid = std::max(lit.first_entered + latency, last_left_ + 1);
  lit.sink_rank = sink_.always() ? lit.first_valid : sink_.Rank(lit.first_valid);
  lit.last_left =
      sink_.always() ? lit.first_valid + groups - 1 : sink_.Select(lit.sink_rank + groups - 1);
  queue_.Add({first, groups, lit.first_valid, lit.sink_rank});
  lit.last_entered =
      std::max(lit.first_entered + groups - 1, queue_.RoomFor(first + groups - 1, sink_) + 1);
  return lit;
}

void ShadingClock::Leave(int64_t groups, SpanTiming* timing) {
  if (auto_ || LightsPixels(method_)) {
    const int64_t latency = !auto_ ? LightLatency(method_)
                            : LightsPixels(method_) ? LightLatency(Method::kAuto)
                                                    : PixelQueue::kContract.latency_cycles;
    const Lit lit = Light(seed_taken_ + 1, groups, latency);
    timing->first_valid = lit.first_valid;
    timing->sink_rank = lit.sink_rank;
    timing->last_left = lit.last_left;
    walker_free_ = lit.last_entered;
    return;
  }
  timing->first_valid = seed_taken_ + 1;
  timing->sink_rank = sink_.always() ? timing->first_valid : sink_.Rank(timing->first_valid);
  timing->last_left = sink_.always() ? timing->first_valid + groups - 1
                                     : sink_.Select(timing->sink_rank + groups - 1);
  walker_free_ = timing->last_left;
}

void ShadingClock::LeaveFootprints(int64_t groups, int samples, SpanTiming* timing) {
  left_.clear();
  walker_free_ = seed_taken_;
  for (int64_t i = 0; i < groups; ++i) {
    const Lit lit = Light(walker_free_ + samples, 1, LightLatency(method_));
    if (i == 0) {
      timing->first_valid = lit.first_valid;
      timing->sink_rank = lit.sink_rank;
    }
    timing->setup += lit.first_valid - 1 - std::max(timing->accepted, last_left_);
    timing->stall += lit.last_left - lit.first_valid;
    left_.push_back(lit.last_left);
    last_left_ = lit.last_left;
    walker_free_ = lit.last_entered;
  }
  timing->last_left = last_left_;
}

SpanTiming ShadingClock::AdaptiveSpan(int setup_cycles,
                                      const std::vector<AdaptiveSegment>& segments, bool last) {
  SpanTiming timing;
  span_taken_ = std::max(binder().OfferRun(source_.Next(span_taken_ + 1)), adaptive_.free());
  binder().PassSpan(span_taken_, last);
  adaptive_.TakeSpan(span_taken_, setup_cycles);
  timing.accepted = span_taken_;
  left_.clear();
  for (const AdaptiveSegment& segment : segments) {
    adaptive_.Segment(segment, [&](int64_t offered, int64_t groups) {
      const Lit lit = Light(offered, groups, LightLatency(method_));
      if (left_.empty()) {
        timing.first_valid = lit.first_valid;
        timing.sink_rank = lit.sink_rank;
      }
      timing.setup += lit.first_valid - 1 - std::max(timing.accepted, last_left_);
      timing.stall += lit.last_left - lit.first_valid + 1 - groups;
      for (int64_t i = 0; i < groups; ++i) {
        left_.push_back(sink_.always() ? lit.first_valid + i : sink_.Select(lit.sink_rank + i));
      }
      last_left_ = lit.last_left;
      return lit.last_entered;
    });
  }
  timing.last_left = last_left_;
  return timing;
}

SpanTiming ShadingClock::Span(int length, int rows, bool last, int samples) {
  SpanTiming timing;
  const int64_t offered = source_.Next(span_taken_ + 1);
  const int64_t seed_offered = InterpolatesNormals(method_) ? OfferNormalSeed(offered, last)
                                                            : OfferSurfaceSeed(offered, rows, last);
  seed_taken_ = std::max(seed_offered, walker_free_);
  if (!InterpolatesNormals(method_)) {
    if (auto_) seed_queue_.Leave(seed_taken_);
    else surface_seed_taken_ = seed_taken_;
  } else if (method_ != Method::kSlerpDirect) {
    normal_seed_taken_ = seed_taken_;
  }
  timing.accepted = span_taken_;
  const int64_t groups = (length + lanes_ - 1) / lanes_;
  if (IsFootprint(method_)) {
    LeaveFootprints(groups, samples, &timing);
    return timing;
  }
  Leave(groups, &timing);
  timing.setup = timing.first_valid - 1 - std::max(timing.accepted, last_left_);
  timing.stall = timing.last_left - timing.first_valid + 1 - groups;
  last_left_ = timing.last_left;
  return timing;
}

}  // namespace shading
