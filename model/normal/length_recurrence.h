// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/second_difference.h"
#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/length_recurrence.sv: q = |M|^2 along a span.
//
//   q(t+1) = q(t) + d(t),   d(t+1) = d(t) + c
//
// The recurrence is exact; seeds rounded to 2^-45 move step t by (1 + t + t (t - 1)/2)/2 ulp.
class LengthRecurrence {
 public:
  static constexpr UnitContract kContract = {
      "length_recurrence", "normal",  1,         1,
      "seed S1.44",        "q S1.44", 1048064.5, "spans of 2048 pixels"};

  LengthRecurrence() = default;
  explicit LengthRecurrence(const LengthSeed& seed) : curve_(seed) {}

  LengthSquare value() const { return FromAligned<LengthSquare>(curve_.value()); }
  void Step() { curve_.Step(); }

 private:
  SecondDifference<> curve_;
};

}  // namespace shading
