// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "model/intensity/flat_color.h"
#include "model/intensity/second_difference.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_split.sv: one channel of one span, diffuse and specular
// light as two surfaces of paper 003, each clamped at 0, and added.
//
//   I(x) = ambient + max(0, D(x)) + max(0, S(x)),  D and S by two-register differences
//
// The recurrences are exact; seeds rounded to 2^-27 codes move pixel t by at most
// 2 (1 + t + t (t - 1) / 2) 2^-27 codes.
class QuadSplit {
 public:
  static constexpr UnitContract kContract = {"quad_split",
                                             "intensity",
                                             1,
                                             1,
                                             "seeds S9.26, ambient S9.26",
                                             "code U8.0, truncate, clamp",
                                             0.0313,
                                             "spans of 2048 pixels, before the code is rounded"};

  QuadSplit(const ChannelSeed& diffuse, const SplitSeed& split)
      : diffuse_(diffuse), specular_(split.specular), ambient_(split.ambient.raw()) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return sum() >> IntensityAcc::kFraction; }         // before the clamp
  int64_t sum() const { return ambient_ + Lit(diffuse_) + Lit(specular_); }  // 2^26 I
  void Step() {
    diffuse_.Step();
    specular_.Step();
  }

 private:
  static int64_t Lit(const SecondDifference<>& term) {
    return std::max<int64_t>(FromAligned<IntensityAcc>(term.value()).raw(), 0);
  }

  SecondDifference<> diffuse_, specular_;
  int64_t ambient_;
};

}  // namespace shading
