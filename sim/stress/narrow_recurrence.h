// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/normal/normal_types.h"
#include "sim/stress/check.h"

namespace shading::stress {

// s(t) = cos(start + t phi), any component of a turning unit vector.
struct Arc {
  Real phi, start;
  Real At(int t) const { return std::cos(start + phi * t); }
  Real FirstDifference() const { return -2 * std::sin(start + phi / 2) * std::sin(phi / 2); }
};

// 4 sin^2(phi / 2), rounded to nearest.
inline Kappa KappaOf(Real phi) {
  const Real half = std::sin(phi / 2), kappa = 4 * half * half;
  int exponent = kMaxKappaExponent;
  while (exponent > 0 && std::ldexp(kappa, 2 * exponent) > 1) --exponent;
  return {U<1, 28>::Saturate(RoundTo(kappa, 28 + 2 * exponent)), exponent};
}

// slerp_recurrence with F instead of 38 fraction bits, its multiplier with F - 10: with F = 38 and
// rounding it is the unit, bit by bit.
class NarrowRecurrence {
 public:
  NarrowRecurrence(const Arc& arc, int fraction_bits, bool truncate = false)
      : truncate_(truncate),
        value_(RoundTo(arc.At(0), fraction_bits)),
        difference_(RoundTo(arc.FirstDifference(), fraction_bits)) {
    const Kappa kappa = KappaOf(arc.phi);
    mantissa_ = kappa.mantissa.raw();
    shift_ = 18 + 2 * kappa.exponent;
  }
  int64_t value() const { return value_; }
  void Step() {
    value_ += difference_;
    const int64_t operand = (value_ + (truncate_ ? 0 : 512)) >> 10;
    const int64_t half = truncate_ ? 0 : int64_t{1} << (shift_ - 1);
    difference_ -= (mantissa_ * operand + half) >> shift_;
  }

 private:
  bool truncate_;
  int64_t value_, difference_, mantissa_ = 0;
  int shift_ = 0;
};

}  // namespace shading::stress
