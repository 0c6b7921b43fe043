// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "model/choice/seed_queue.h"
#include "model/flow_pattern.h"
#include "model/normal/adaptive_clock.h"
#include "model/normal/normal_setup.h"
#include "model/normal/slerp_direct_setup.h"
#include "model/normal/stage_clock.h"
#include "model/raster/pixel_queue.h"
#include "model/raster/span_binder.h"
#include "model/shading_types.h"

namespace shading {

// When one span moves through the shading unit, in cycles from the acceptance of its frame.
struct SpanTiming {
  int64_t accepted = 0;     // the span command is taken
  int64_t first_valid = 0;  // its first group of pixels is on offer
  int64_t sink_rank = 0;    // group i leaves in the sink's willing cycle number sink_rank + i
  int64_t last_left = 0;    // its last group leaves
  int64_t setup = 0;        // cycles without a pixel on offer although the span is inside
  int64_t stall = 0;        // cycles in which pixels wait for the sink
};

// Exact cycles of rtl/shading_unit.sv, per span and not per cycle. Every stage is in order:
//
//   start = max(input on offer, stage free, room downstream)
//
//   span_setup     accepts in a, starts in steps, finishes, sums in s, offers the seed from s + 1;
//                  a span waiting for its sum holds those behind it
//   normal_setup   accepts in a, passes from stage to stage every 8 cycles, offers likewise
//   pixel_walker   takes the seed in t, offers the first group of lanes in t + 1
//   light          takes a group when pixel_queue has room and offers it a fixed time later
//   footprints     a group's samples come cycle by cycle; with the last one it enters the queue
//   adaptive       accepts in a, gives groups to the light segment by segment: AdaptiveClock
//   auto           choice_stage passes a triangle when the spans before it are taken; seeds of
//                  surfaces wait in seed_queue; every group goes through pixel_queue
//
// The source pattern says in which cycles a new triangle or span command may appear; once on offer
// it stays. The sink pattern says in which cycles pixels are taken.
class ShadingClock {
 public:
  // Method of the frame.
  ShadingClock(Method method, int lanes, FlowPattern source, FlowPattern sink);

  // The next triangle command and, in auto frames, its method; its spans follow.
  void Triangle(Method method);
  // rows: from the span before in the same triangle, 0 for the first.
  // samples: cycles of a group at the light, footprint methods.
  SpanTiming Span(int length, int rows, bool last, int samples = 1);
  // The same of an adaptive method. first_valid and sink_rank are those of its first segment.
  SpanTiming AdaptiveSpan(int setup_cycles, const std::vector<AdaptiveSegment>& segments,
                          bool last);
  // The cycle in which a group of the latest span of an adaptive or footprint method left.
  int64_t LeftOf(int64_t group) const { return left_[static_cast<size_t>(group)]; }

  const FlowPattern& sink() const { return sink_; }
  int lanes() const { return lanes_; }

 private:
  SpanBinder& binder() { return binder_[InterpolatesNormals(method_)]; }
  int64_t OfferSurfaceSeed(int64_t offered, int rows, bool last);
  int64_t OfferNormalSeed(int64_t offered, bool last);
  // Groups on their way through the light, without a gap: the first and the last enter, the first
  // is on offer and the last leaves.
  struct Lit {
    int64_t first_entered, last_entered, first_valid, sink_rank, last_left;
  };
  Lit Light(int64_t offered, int64_t groups, int64_t latency);
  void Leave(int64_t groups, SpanTiming* timing);
  // Group by group: each enters with its last sample.
  void LeaveFootprints(int64_t groups, int samples, SpanTiming* timing);

  bool auto_;
  Method method_;  // of the current triangle
  int lanes_;
  FlowPattern source_;
  FlowPattern sink_;

  // Of surfaces and of normals: span_setup holds its triangle as span_binder does, until the last
  // span's last step.
  std::array<SpanBinder, 2> binder_;
  int64_t triangle_taken_ = 0;  // at the port
  int64_t stage_left_ = 0;      // choice_stage gave up the triangle before
  SeedQueue seed_queue_;        // auto
  int64_t span_taken_ = 0;  // of the span before, and so on
  int64_t last_step_ = 0;   // span_setup, as the next three
  int64_t finish_ = 0;      // its last product
  int64_t sum_ = 0;
  int64_t older_sum_ = 0;   // of the span before that
  StageClock normal_setup_;
  StageClock arc_setup_;
  AdaptiveClock adaptive_;
  std::vector<int64_t> left_;      // of the groups of the latest span: LeftOf
  int64_t surface_seed_taken_ = 0;  // of span_setup, by seed_queue or pixel_walker
  int64_t normal_seed_taken_ = 0;  // of normal_setup, by slerp_direct_setup or pixel_walker
  int64_t seed_taken_ = 0;         // by pixel_walker
  int64_t walker_free_ = 0;        // the last group of the span before leaves pixel_walker
  int64_t last_left_ = 0;
  PixelQueue queue_;
};

}  // namespace shading
