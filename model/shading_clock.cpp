// SPDX-License-Identifier: Apache-2.0
#include "model/shading_clock.h"

#include <algorithm>
#include <utility>

#include "model/light/pixel_light.h"
#include "model/normal/normal_shader.h"
#include "model/raster/span_setup.h"

namespace shading {
namespace {

// A group leaves pixel_walker in some cycle and is on offer so many cycles later.
constexpr int64_t LightLatency(Method method) {
  return CosineLatency(method) + PixelLight::kContract.latency_cycles +
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
    : method_(method), lanes_(lanes), source_(std::move(source)), sink_(std::move(sink)) {}

void ShadingClock::Triangle() {
  constexpr int64_t kLead = FlowPattern::kTriangleLead;
  const int64_t offered = source_.Next(triangle_taken_ + 1 + kLead) - kLead;
  triangle_taken_ = std::max(offered, triangle_released_);
}

int64_t ShadingClock::OfferSurfaceSeed(int64_t offered, bool last) {
  span_taken_ = std::max({offered, triangle_taken_, last_step_});
  // The first step shares its cycle with the last sum of the span before, which may be waiting for
  // the seed register.
  const int64_t first_step = std::max(span_taken_ + 1, sum_);
  last_step_ = first_step + SpanSetup::Steps(method_) - 1;
  sum_ = std::max(last_step_ + 1, seed_taken_);
  if (last) triangle_released_ = last_step_;
  return sum_ + 1;
}

// Stage j is free when the span before enters stage j + 1; the register after the last stage, when
// its seed is taken.
int64_t ShadingClock::OfferNormalSeed(int64_t offered, bool last) {
  const auto stages = static_cast<size_t>(NormalSetup::StageCount(lanes_));
  span_taken_ = std::max({offered, triangle_taken_, stage_entered_[1]});
  stage_entered_[0] = span_taken_;
  for (size_t j = 1; j <= stages; ++j) {
    const int64_t free = j < stages ? stage_entered_[j + 1] : normal_seed_taken_;
    stage_entered_[j] = std::max(stage_entered_[j - 1] + NormalSetup::kSteps, free);
  }
  if (last) triangle_released_ = span_taken_;
  return stage_entered_[stages] + 1;
}

int64_t ShadingClock::OfferArc(int64_t seed_offered) {
  constexpr size_t kStages = SlerpDirectSetup::kStages;
  normal_seed_taken_ = std::max(seed_offered, arc_stage_entered_[1]);
  arc_stage_entered_[0] = normal_seed_taken_;
  for (size_t j = 1; j <= kStages; ++j) {
    const int64_t free = j < kStages ? arc_stage_entered_[j + 1] : seed_taken_;
    arc_stage_entered_[j] = std::max(arc_stage_entered_[j - 1] + NormalSetup::kSteps, free);
  }
  return arc_stage_entered_[kStages] + 1;
}

// Groups enter the light as the queue has room. Room for a later group never comes so late that the
// groups on offer would break off, since the light takes fewer cycles than the queue has places.
void ShadingClock::Leave(int64_t groups, SpanTiming* timing) {
  const bool lit = InterpolatesNormals(method_);
  int64_t first_entered = seed_taken_ + 1;
  if (lit) {
    first_entered = std::max(first_entered, queue_.RoomFor(queue_.groups(), sink_) + 1);
    timing->first_valid = std::max(first_entered + LightLatency(method_), last_left_ + 1);
  } else {
    timing->first_valid = first_entered;
  }
  timing->sink_rank = sink_.always() ? timing->first_valid : sink_.Rank(timing->first_valid);
  timing->last_left = sink_.always() ? timing->first_valid + groups - 1
                                     : sink_.Select(timing->sink_rank + groups - 1);
  walker_free_ = timing->last_left;
  if (!lit) return;
  const int64_t first = queue_.groups();
  queue_.Add({first, groups, timing->first_valid, timing->sink_rank});
  walker_free_ =
      std::max(first_entered + groups - 1, queue_.RoomFor(first + groups - 1, sink_) + 1);
}

SpanTiming ShadingClock::Span(int length, bool last) {
  SpanTiming timing;
  const int64_t offered = source_.Next(span_taken_ + 1);
  int64_t seed_offered = InterpolatesNormals(method_) ? OfferNormalSeed(offered, last)
                                                      : OfferSurfaceSeed(offered, last);
  const bool has_arc = method_ == Method::kSlerpDirect;
  if (has_arc) seed_offered = OfferArc(seed_offered);
  seed_taken_ = std::max(seed_offered, walker_free_);
  if (!has_arc) normal_seed_taken_ = seed_taken_;
  timing.accepted = span_taken_;
  const int64_t groups = (length + lanes_ - 1) / lanes_;
  Leave(groups, &timing);
  timing.setup = timing.first_valid - 1 - std::max(timing.accepted, last_left_);
  timing.stall = timing.last_left - timing.first_valid + 1 - groups;
  last_left_ = timing.last_left;
  return timing;
}

}  // namespace shading
