// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace shading {

// Cycles of rtl/choice/seed_queue.sv: kDepth seeds of surfaces wait for the walker.
class SeedQueue {
 public:
  static constexpr size_t kDepth = 8;

  // A seed is on offer to the queue from cycle `offered` on. Returns when the queue takes it; a
  // cycle later it is on offer to the walker.
  int64_t Take(int64_t offered) const { return std::max(offered, taken_[next_]); }
  // The walker takes that seed.
  void Leave(int64_t cycle) {
    taken_[next_] = cycle;
    next_ = (next_ + 1) % kDepth;
  }

 private:
  std::array<int64_t, kDepth> taken_ = {};  // by the walker, of the last kDepth seeds
  size_t next_ = 0;
};

}  // namespace shading
