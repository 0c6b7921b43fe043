// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_third_difference.sv: one channel of one span, paper 003 (8)
// with its product by 3 as a shift and an addition (figure 5).
//
//   I(x+3) = 3 I(x+2) - 3 I(x+1) + I(x)
//
// The recurrence is exact; I(0), I(1) and I(2) rounded to 2^-27 codes move pixel t by at most
// (2t^2 - 4t + 1) 2^-27 codes. I(2) = second + difference + curvature of the seed.
template <typename Word = uint64_t>
class BasicQuadThirdDifference {
 public:
  static constexpr UnitContract kContract = {"quad_third_difference",
                                             "intensity",
                                             1,
                                             1,
                                             "seed S9.26",
                                             "code U8.0, truncate, clamp",
                                             0.0624,
                                             "spans of 2048 pixels, before the code is rounded"};

  explicit BasicQuadThirdDifference(const ChannelSeed& seed)
      : current_(ToWord<Word>(seed.first)),
        next_(ToWord<Word>(seed.second)),
        third_(next_ + ToWord<Word>(seed.difference) + ToWord<Word>(seed.curvature)) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(Bits(current_)); }  // before the clamp
  void Step() {
    const Word rise = third_ - next_;
    const Word ahead = (rise << 1) + rise + current_;
    current_ = next_;
    next_ = third_;
    third_ = ahead;
  }

 private:
  Word current_;  // I(x)
  Word next_;     // I(x+1)
  Word third_;    // I(x+2)
};

using QuadThirdDifference = BasicQuadThirdDifference<>;

}  // namespace shading
