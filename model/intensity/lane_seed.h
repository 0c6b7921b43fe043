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
// Sums modulo 2^36 of integers, 2^46 for cosines: exact wherever the value itself is in range.
class LaneSeed {
 public:
  static constexpr UnitContract kContract = {"lane_seed",  "intensity",  0, 1,
                                             "seed S9.26", "seed S9.26", 0, "results in S9.26"};

  template <typename Value>
  static BasicSeed<Value> Of(const BasicSeed<Value>& seed, int lane, int lanes) {
    if (lanes == 1) return seed;
    const Value first = Pixel(seed, lane), second = Pixel(seed, lane + lanes);
    return {first, second, Value::Wrap(second.raw() - first.raw()),
            Value::Wrap(lanes * lanes * seed.curvature.raw())};
  }

 private:
  template <typename Value>
  static Value Pixel(const BasicSeed<Value>& seed, int j) {
    return Value::Wrap(seed.first.raw() + j * seed.difference.raw() +
                       j * (j - 1) / 2 * seed.curvature.raw());
  }
};

}  // namespace shading
