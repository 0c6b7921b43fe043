// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "model/flow_pattern.h"
#include "model/unit_contract.h"

namespace shading {

// Cycle model of rtl/raster/pixel_queue.sv: when the groups of pixels that left the unit did so.
// The queue holds kDepth groups, so group g enters after group g - kDepth left.
class PixelQueue {
 public:
  static constexpr UnitContract kContract = {"pixel_queue",
                                             "raster",
                                             1,
                                             1,
                                             "positions, codes U8.0",
                                             "pixels in their order",
                                             0,
                                             "light of less than 64 cycles"};
  static constexpr int64_t kDepth = 64;  // groups

  // The groups of a span, or of a segment of an adaptive one: group i leaves in cycle first_valid +
  // i, or in the sink's willing cycle number sink_rank + i.
  struct Run {
    int64_t first_group, groups;
    int64_t first_valid, sink_rank;
  };

  int64_t groups() const { return next_; }  // so far
  void Add(const Run& run) {
    runs_[static_cast<size_t>(count_++) % runs_.size()] = run;
    next_ = run.first_group + run.groups;
  }

  // The cycle in which a place for `group` became free: when the group kDepth before it left.
  // Groups are asked for in rising order.
  int64_t RoomFor(int64_t group, const FlowPattern& sink) {
    const int64_t gone = group - kDepth;
    if (gone < 0) return -1;
    while (at(oldest_).first_group + at(oldest_).groups <= gone) ++oldest_;
    const Run& run = at(oldest_);
    const int64_t i = gone - run.first_group;
    return sink.always() ? run.first_valid + i : sink.Select(run.sink_rank + i);
  }

 private:
  const Run& at(int64_t index) const { return runs_[static_cast<size_t>(index) % runs_.size()]; }

  std::array<Run, 2 * kDepth> runs_ = {};  // kDepth groups lie in at most kDepth + 1 runs
  int64_t count_ = 0, oldest_ = 0, next_ = 0;
};

}  // namespace shading
