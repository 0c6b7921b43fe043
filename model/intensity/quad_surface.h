// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_surface.sv: one channel of one span, paper 003 (5).
//
//   I(x+2) = 2 I(x+1) - I(x) + 2A
//
// The recurrence is exact; seeds rounded to 2^-27 codes move pixel t by (t^2 + t - 1) 2^-27 codes.
class QuadSurface {
 public:
  static constexpr UnitContract kContract = {"quad_surface",
                                             "intensity",
                                             1,
                                             1,
                                             "seed S9.26",
                                             "code U8.0, truncate, clamp",
                                             0.0313,
                                             "spans of 2048 pixels, before the code is rounded"};

  explicit QuadSurface(const ChannelSeed& seed)
      : current_(Align(seed.first)), next_(Align(seed.second)), curvature_(Align(seed.curvature)) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(current_); }  // before the clamp
  void Step() {
    const uint64_t ahead = 2 * next_ - current_ + curvature_;
    current_ = next_;
    next_ = ahead;
  }

 private:
  uint64_t current_;    // I(x)
  uint64_t next_;       // I(x+1)
  uint64_t curvature_;  // 2A
};

}  // namespace shading
