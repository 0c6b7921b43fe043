// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_midpoint.sv: one channel of one span, even pixels by paper
// 003 (5) with twice the stride, odd ones by (6).
//
//   x even:  I(x+4) = 2 I(x+2) - I(x) + 8A       I(x+1) = [I(x) + I(x+2)] / 2 - A
//
// Both are exact: the word has room for the half ulp of an odd 2A, and what is halved is even.
// I(0), I(1) - I(0) and A rounded to 2^-27 codes move pixel t by at most (t^2 + 1) 2^-27 codes.
template <typename Word = uint64_t>
class BasicQuadMidpoint {
 public:
  static constexpr UnitContract kContract = {"quad_midpoint",
                                             "intensity",
                                             1,
                                             1,
                                             "seed S9.26",
                                             "code U8.0, truncate, clamp",
                                             0.0313,
                                             "spans of 2048 pixels, before the code is rounded"};

  explicit BasicQuadMidpoint(const ChannelSeed& seed)
      : shown_(ToWord<Word>(seed.first)),
        current_(shown_),
        next_(current_ + (ToWord<Word>(seed.difference) << 1) + ToWord<Word>(seed.curvature)),
        half_curvature_(ToWord<Word>(seed.curvature) >> 1),
        far_curvature_(ToWord<Word>(seed.curvature) << 2) {}

  uint8_t code() const { return ClampCode(whole()); }
  // Before the clamp. A midpoint is half of a sum modulo 1024 codes, so it is known modulo 512: the
  // residue in -128..383 is the value, for shown ones lie in -86..341.
  int64_t whole() const {
    const int64_t whole = WholeCodes(Bits(shown_));
    return odd_ ? ((whole + 128) & 511) - 128 : whole;
  }
  void Step() {
    odd_ = !odd_;
    if (odd_) {
      shown_ = ((current_ + next_) >> 1) - half_curvature_;
      return;
    }
    const Word ahead = (next_ << 1) - current_ + far_curvature_;
    shown_ = next_;
    current_ = next_;
    next_ = ahead;
  }

 private:
  Word shown_;           // the pixel: I(x), or the midpoint I(x+1) when odd_
  Word current_;         // I(x), x even
  Word next_;            // I(x+2)
  Word half_curvature_;  // A modulo 512 codes
  Word far_curvature_;   // 8A
  bool odd_ = false;
};

using QuadMidpoint = BasicQuadMidpoint<>;

}  // namespace shading
