// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/lane_seed.h"
#include "model/intensity/second_difference.h"
#include "model/light/cosine.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/light/quad_cosine.sv: N.L or N.H, unclamped, along one span of a surface
// of second order, paper 003; lane j of `lanes` starts at pixel j.
//
//   c(t+1) = c(t) + d(t),  d(t+1) = d(t) + 2A
//
// The recurrence is exact; seeds rounded to 2^-45 move pixel t by (1 + t + t (t - 1) / 2) 2^-45.
// The cosine is rounded half up to S1.30 and saturates.
class QuadCosine {
 public:
  static constexpr UnitContract kContract = {"quad_cosine",
                                             "light",
                                             1,
                                             1,
                                             "seed S1.44",
                                             "cosine S1.30, round to nearest, saturate",
                                             64.5,
                                             "spans of 2048 pixels"};

  QuadCosine() = default;
  explicit QuadCosine(const CurveSeed& seed, int lane = 0, int lanes = 1)
      : curve_(LaneSeed::Of(seed, lane, lanes)) {}

  Cosine value() const {
    return RoundSaturateCosine(FromAligned<CosineAcc>(curve_.value()).raw(),
                               CosineAcc::kFraction - Cosine::kFraction);
  }
  void Step() { curve_.Step(); }

 private:
  SecondDifference<> curve_;
};

}  // namespace shading
