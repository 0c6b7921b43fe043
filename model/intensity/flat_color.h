// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Integer part of an S9.26 accumulator that is shifted to the top of 64 bits: -512..511.
inline int64_t WholeCodes(uint64_t aligned) {
  constexpr int kShift = 64 - IntensityAcc::kWidth + IntensityAcc::kFraction;
  return static_cast<int64_t>(aligned) >> kShift;
}

// S9.26 -> U8.0: the fraction is truncated before, here the range is clamped to 0..255.
inline uint8_t ClampCode(int64_t whole) {
  return static_cast<uint8_t>(whole < 0 ? 0 : whole > Code::kMaxRaw ? Code::kMaxRaw : whole);
}

// Bit-exact model of rtl/intensity/flat_color.sv: one channel of one span.
//
//   I(x) = F
class FlatColor {
 public:
  static constexpr UnitContract kContract = {
      "flat_color", "intensity", 1, 1, "seed S9.26", "code U8.0, truncate, clamp", 0, "any seed"};

  explicit FlatColor(const ChannelSeed& seed) : code_(ClampCode(WholeCodes(Align(seed.first)))) {}

  uint8_t code() const { return code_; }
  int64_t whole() const { return code_; }  // before the clamp
  void Step() {}

 private:
  uint8_t code_;
};

}  // namespace shading
