// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "model/normal/adaptive_normalizer.h"

namespace shading {

// Cycles of rtl/normal/adaptive_normalizer.sv, per segment and not per cycle. With every number a
// cycle, for segment q of span k:
//
//   span taken       a(k) >= b(k-1)
//   handed over      b(k) = max(a(k) + set-up, last issue of k-1)
//   issued           i(q) = max(i(q-1) or b(k), + steps, l(q-8) + 1)       the queue holds 8
//   loaded           l(q) = max(i(q) + 4, f(q-1))
//   filled           f(q): its last group left; one cycle later when a group is left to gather
class AdaptiveClock {
 public:
  struct Timing {
    int64_t issued, loaded, filled;
  };

  explicit AdaptiveClock(int lanes) : lanes_(lanes) { loaded_.fill(-1); }

  int64_t free() const { return handed_over_; }  // the first cycle in which a span is taken
  void TakeSpan(int64_t taken, int setup_cycles) {
    handed_over_ = std::max(taken + setup_cycles, issued_);
    issued_ = handed_over_;
  }

  // leave(first, groups): the cycle in which the last of the segment's groups leaves; the first is
  // on offer from cycle `first` on. It is not called for a segment that completes no group.
  template <typename Leave>
  Timing Segment(const AdaptiveSegment& segment, const Leave& leave) {
    int64_t& loaded = loaded_[static_cast<size_t>(segments_++ % AdaptiveNormalizer::kQueue)];
    issued_ = std::max(issued_ + segment.steps, loaded + 1);
    loaded = std::max(issued_ + AdaptiveNormalizer::kSegmentLatency, filled_);
    const int end = lane_ + segment.count;
    const int groups = (segment.last ? end + lanes_ - 1 : end) / lanes_;
    filled_ = groups > 0 ? leave(loaded + 1, groups) : loaded;
    lane_ = segment.last ? 0 : end % lanes_;
    if (lane_ != 0) ++filled_;
    return {issued_, loaded, filled_};
  }

 private:
  int lanes_;
  int64_t handed_over_ = 0, issued_ = 0, filled_ = 0;
  int64_t segments_ = 0;
  std::array<int64_t, AdaptiveNormalizer::kQueue> loaded_;  // of the latest segments
  int lane_ = 0;                                            // of the next segment's first pixel
};

}  // namespace shading
