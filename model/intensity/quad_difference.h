// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_difference.sv: one channel of one span by forward
// differences, paper 003 (3) with its slope kept.
//
//   I(x+1) = I(x) + d(x)      d(x+1) = d(x) + 2A
//
// The recurrence is exact; I(0), d(0) and 2A rounded to 2^-27 codes move pixel t by at most
// (1 + t + t(t-1)/2) 2^-27 codes.
template <typename Word = uint64_t>
class BasicQuadDifference {
 public:
  static constexpr UnitContract kContract = {
      "quad_difference",
      "intensity",
      1,
      1,
      "seed S9.26",
      "code U8.0, truncate, clamp",
      0.0157,
      "spans of 2048 pixels, 2A rounded, before the code is rounded"};

  explicit BasicQuadDifference(const ChannelSeed& seed)
      : current_(ToWord<Word>(seed.first)),
        difference_(ToWord<Word>(seed.difference)),
        curvature_(ToWord<Word>(seed.curvature)) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(Bits(current_)); }  // before the clamp
  void Step() {
    current_ = current_ + difference_;
    difference_ = difference_ + curvature_;
  }

 private:
  Word current_;     // I(x)
  Word difference_;  // d(x) = I(x+1) - I(x)
  Word curvature_;   // 2A
};

using QuadDifference = BasicQuadDifference<>;

}  // namespace shading
