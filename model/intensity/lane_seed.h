// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/intensity/lane_seed.sv: lane j of `lanes` begins at pixel j and steps
// `lanes` pixels.
//
//   I(j) = I(0) + j D + j (j - 1) / 2 2A,  D = I(1) - I(0)          paper 003 (3)
//   D' = I(j + lanes) - I(j),  2A' = lanes^2 2A
//
// Sums modulo 2^36 of integers: exact wherever the intensity itself lies in S9.26.
class LaneSeed {
 public:
  static constexpr UnitContract kContract = {"lane_seed",  "intensity",  0, 1,
                                             "seed S9.26", "seed S9.26", 0, "results in S9.26"};

  static ChannelSeed Of(const ChannelSeed& seed, int lane, int lanes) {
    if (lanes == 1) return seed;
    const IntensityAcc first = Pixel(seed, lane), second = Pixel(seed, lane + lanes);
    return {first, second, IntensityAcc::Wrap(second.raw() - first.raw()),
            IntensityAcc::Wrap(lanes * lanes * seed.curvature.raw())};
  }

 private:
  static IntensityAcc Pixel(const ChannelSeed& seed, int j) {
    return IntensityAcc::Wrap(seed.first.raw() + j * seed.difference.raw() +
                              j * (j - 1) / 2 * seed.curvature.raw());
  }
};

}  // namespace shading
