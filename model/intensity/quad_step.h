// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_step.sv: one channel of one span, paper 003 (3), one
// product for every pixel.
//
//   I(t+1) = I(t) + d(0) + t 2A,  d(0) = I(1) - I(0)
//
// The sum is exact; seeds rounded to 2^-27 codes move pixel t by (t^2 + 1) 2^-27 codes.
template <typename Word = uint64_t>
class BasicQuadStep {
 public:
  static constexpr UnitContract kContract = {"quad_step",
                                             "intensity",
                                             1,
                                             1,
                                             "seed S9.26",
                                             "code U8.0, truncate, clamp",
                                             0.0313,
                                             "spans of 2048 pixels, before the code is rounded"};

  explicit BasicQuadStep(const ChannelSeed& seed)
      : current_(ToWord<Word>(seed.first)),
        difference_(ToWord<Word>(seed.difference)),
        curvature_(ToWord<Word>(seed.curvature)) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(Bits(current_)); }  // before the clamp
  void Step() { current_ = current_ + difference_ + curvature_ * Word(t_++); }

 private:
  Word current_;     // I(t)
  Word difference_;  // d(0)
  Word curvature_;   // 2A
  uint64_t t_ = 0;
};

using QuadStep = BasicQuadStep<>;

}  // namespace shading
