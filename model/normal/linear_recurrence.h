// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/linear_recurrence.sv: one quantity of one span or lane.
//
//   s(t+1) = s(t) + D
//
// The recurrence is exact; seeds rounded to 2^-39 move step t by (t + 1) / 2 ulp.
class LinearRecurrence {
 public:
  static constexpr UnitContract kContract = {
      "linear_recurrence",   "normal", 1, 1, "seed S1.38", "value S1.38, wraps", 1024,
      "spans of 2048 pixels"};

  LinearRecurrence() = default;
  explicit LinearRecurrence(const QuantitySeed& seed)
      : value_(Align(seed.first)), difference_(Align(seed.difference)) {}

  Quantity value() const { return FromAligned<Quantity>(value_); }
  void Step() { value_ += difference_; }

 private:
  uint64_t value_ = 0;       // s(t)
  uint64_t difference_ = 0;  // D
};

}  // namespace shading
