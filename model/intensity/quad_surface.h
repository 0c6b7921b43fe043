// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_surface.sv: one channel of one span, paper 003 (5).
//
//   I(x+2) = 2 I(x+1) - I(x) + 2A
//
// The recurrence is exact; seeds rounded to 2^-27 codes move pixel t by (t^2 + t - 1) 2^-27 codes.
template <typename Word = uint64_t>
class BasicQuadSurface {
 public:
  static constexpr UnitContract kContract = {"quad_surface",
                                             "intensity",
                                             1,
                                             1,
                                             "seed S9.26",
                                             "code U8.0, truncate, clamp",
                                             0.0313,
                                             "spans of 2048 pixels, before the code is rounded"};

  explicit BasicQuadSurface(const ChannelSeed& seed)
      : current_(ToWord<Word>(seed.first)),
        next_(ToWord<Word>(seed.second)),
        curvature_(ToWord<Word>(seed.curvature)) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(Bits(current_)); }  // before the clamp
  void Step() {
    const Word ahead = (next_ << 1) - current_ + curvature_;
    current_ = next_;
    next_ = ahead;
  }

 private:
  Word current_;    // I(x)
  Word next_;       // I(x+1)
  Word curvature_;  // 2A
};

using QuadSurface = BasicQuadSurface<>;

}  // namespace shading
