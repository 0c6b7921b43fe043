// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "model/intensity/flat_color.h"

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
  int64_t whole() const { return sum() >> IntensityAcc::kFraction; }           // before the clamp
  int64_t sum() const { return ambient_ + diffuse_.Lit() + specular_.Lit(); }  // 2^26 I
  void Step() {
    diffuse_.Step();
    specular_.Step();
  }

 private:
  struct Term {
    explicit Term(const ChannelSeed& seed)
        : value(Align(seed.first)),
          difference(Align(seed.difference)),
          curvature(Align(seed.curvature)) {}
    int64_t Lit() const {
      return std::max<int64_t>(static_cast<int64_t>(value) >> (64 - IntensityAcc::kWidth), 0);
    }
    void Step() {
      value += difference;
      difference += curvature;
    }
    uint64_t value, difference, curvature;
  };

  Term diffuse_, specular_;
  int64_t ambient_;
};

}  // namespace shading
