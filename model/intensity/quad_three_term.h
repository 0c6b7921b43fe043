// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_three_term.sv: one channel of one span, paper 003 (7).
//
//   I(x+3) = I(x+2) + I(x+1) - I(x) + 4A
//
// The recurrence is exact; I(0), I(1), I(2) and A rounded to 2^-27 codes move pixel t by at most
// (t^2 - t + 1) 2^-27 codes. I(2) = second + difference + curvature of the seed.
template <typename Word = uint64_t>
class BasicQuadThreeTerm {
 public:
  static constexpr UnitContract kContract = {"quad_three_term",
                                             "intensity",
                                             1,
                                             1,
                                             "seed S9.26",
                                             "code U8.0, truncate, clamp",
                                             0.0313,
                                             "spans of 2048 pixels, before the code is rounded"};

  explicit BasicQuadThreeTerm(const ChannelSeed& seed)
      : current_(ToWord<Word>(seed.first)),
        next_(ToWord<Word>(seed.second)),
        third_(next_ + ToWord<Word>(seed.difference) + ToWord<Word>(seed.curvature)),
        curvature_(ToWord<Word>(seed.curvature) << 1) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(Bits(current_)); }  // before the clamp
  void Step() {
    const Word ahead = third_ + next_ - current_ + curvature_;
    current_ = next_;
    next_ = third_;
    third_ = ahead;
  }

 private:
  Word current_;    // I(x)
  Word next_;       // I(x+1)
  Word third_;      // I(x+2)
  Word curvature_;  // 4A
};

using QuadThreeTerm = BasicQuadThreeTerm<>;

}  // namespace shading
