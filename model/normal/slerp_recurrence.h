// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/slerp_recurrence.sv: one quantity of one span or lane, paper 000
// (7), (14) in Reinsch's form.
//
//   s(t+1) = s(t) + d(t),  d(t+1) = d(t) - kappa s(t+1)
//
// The multiplier sees s rounded half up to S1.28, its product is rounded half up to S1.38.
class SlerpRecurrence {
 public:
  static constexpr UnitContract kContract = {
      "slerp_recurrence",
      "normal",
      1,
      1,
      "seed S1.38, kappa U1.28 with exponent of 4, 0..10",
      "value S1.38, wraps",
      1025,
      "2048 pixels that turn at most 90 degrees, amplitude 1; ulp of 2^-28"};

  SlerpRecurrence() = default;
  SlerpRecurrence(const QuantitySeed& seed, const Kappa& kappa)
      : value_(Align(seed.first)),
        difference_(Align(seed.difference)),
        mantissa_(kappa.mantissa.raw()),
        shift_(kRoundingShift + 2 * kappa.exponent) {}

  Quantity value() const { return FromAligned<Quantity>(value_); }
  void Step() {
    value_ += difference_;
    const int64_t operand = static_cast<int64_t>(value_ + kHalfOperand) >> kOperandAlign;
    const int64_t bend = ((mantissa_ * operand >> shift_) + 1) >> 1;  // below 2^43
    difference_ -= static_cast<uint64_t>(bend) << kQuantityAlign;
  }

 private:
  static constexpr int kQuantityAlign = 64 - Quantity::kWidth;
  static constexpr int kOperandAlign = kQuantityAlign + 10;  // S1.28 at the top of 64 bits
  static constexpr uint64_t kHalfOperand = uint64_t{1} << (kOperandAlign - 1);
  static constexpr int kRoundingShift = 17;  // leaves one bit below S1.38, for exponent 0

  uint64_t value_ = 0;       // s(t)
  uint64_t difference_ = 0;  // d(t)
  int64_t mantissa_ = 0;
  int shift_ = 0;
};

}  // namespace shading
