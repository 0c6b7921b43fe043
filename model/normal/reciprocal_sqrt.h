// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "model/fixed/fixed.h"
#include "model/normal/reciprocal_sqrt_table.h"
#include "model/unit_contract.h"

namespace shading {

using SquaredLength = U<2, 44>;

// 1/sqrt(q) = mantissa 2^exponent. Twin of reciprocal_sqrt_t in normal_pkg.sv.
struct ReciprocalRoot {
  U<1, 24> mantissa;  // [1/2, 1], or 0 for q = 0
  int exponent = 0;   // 0..22
};

// Bit-exact model of rtl/normal/reciprocal_sqrt.sv.
//
//   x = q 4^exponent in [1, 4),  mantissa = 1/sqrt(x) = value - (slope - curvature t) t
//
// on each of 256 segments of x, t the place in the segment. |error| < 0.77 ulp of U1.24 for q > 0.
// q = 0 gives the mantissa 0 and exponent 22.
class ReciprocalSqrt {
 public:
  static constexpr UnitContract kContract = {"reciprocal_sqrt",
                                             "normal",
                                             6,
                                             1,
                                             "q U2.44",
                                             "mantissa U1.24, round to nearest, exponent 0..22",
                                             0.77,
                                             "q > 0"};
  static constexpr int kZeroExponent = 22;  // the largest

  static ReciprocalRoot Of(SquaredLength q) {
    const uint64_t raw = static_cast<uint64_t>(q.raw());
    // Pairs of zeros before the highest one bit of 46.
    const int exponent = (__builtin_clzll(raw | 1) - (64 - SquaredLength::kWidth)) / 2;
    const uint64_t mantissa = Mantissa(raw << (2 * exponent));
    return {U<1, 24>::FromRaw(static_cast<int64_t>(raw == 0 ? 0 : mantissa)), exponent};
  }

 private:
  static constexpr int kPlaceBits = 20;  // t U0.20

  // Of x U2.44, [1, 4).
  static uint64_t Mantissa(uint64_t x) {
    const uint64_t upper = x >> 45;  // x >= 2
    const uint64_t place = x >> (17 + upper);
    const uint64_t t = place & ((uint64_t{1} << kPlaceBits) - 1);
    const uint64_t index = upper << 7 | ((place >> kPlaceBits) & 0x7f);

    const uint64_t word = kReciprocalSqrtTable[static_cast<size_t>(index)];
    const uint64_t value = word >> 34, slope = (word >> 13) & 0x1fffff, curvature = word & 0x1fff;
    const uint64_t steepness = slope - ((curvature * (t >> 6)) >> 14);
    return ((value << kPlaceBits) - steepness * t + (uint64_t{1} << 23)) >> 24;
  }
};

}  // namespace shading
