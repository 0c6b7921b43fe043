// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/second_difference.h"

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

  explicit BasicQuadDifference(const ChannelSeed& seed) : curve_(seed) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(Bits(curve_.value())); }  // before the clamp
  void Step() { curve_.Step(); }

 private:
  SecondDifference<Word> curve_;
};

using QuadDifference = BasicQuadDifference<>;

}  // namespace shading
