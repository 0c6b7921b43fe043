// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/fixed/wide_integer.h"
#include "sim/stress/narrow_recurrence.h"

namespace shading::stress {

// Paper 000 (7), N(t+1) = 2 cos(phi) N(t) - N(t-1), with F fraction bits in state and factor; the
// product is rounded to nearest or truncated. Constants and start values are rounded to nearest.
class NarrowPaper {
 public:
  NarrowPaper(const Arc& arc, int fraction_bits, bool truncate)
      : fraction_(fraction_bits),
        half_(truncate ? 0 : int64_t{1} << (fraction_bits - 1)),
        factor_(RoundTo(2 * std::cos(arc.phi), fraction_bits)),
        value_(RoundTo(arc.At(0), fraction_bits)),
        next_(RoundTo(arc.At(1), fraction_bits)) {}

  int64_t value() const { return value_; }
  void Step() {
    const auto product = static_cast<Int128>(factor_) * next_;
    const int64_t after = static_cast<int64_t>((product + half_) >> fraction_) - value_;
    value_ = next_;
    next_ = after;
  }

 private:
  int fraction_;
  int64_t half_, factor_, value_, next_;
};

}  // namespace shading::stress
