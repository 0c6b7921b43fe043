// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "model/light/light_types.h"
#include "model/normal/pixel_square.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/taylor_normalizer.sv: Lyon's normalisation, paper 000.
//
//   N = M (1 - (q - 1)/2 + 3/8 (q - 1)^2),   q = M.M
//
// M in S1.30, truncated, q - 1 in S0.28, truncated, factor U1.27 and N S1.24, rounded to nearest.
// |error| < 0.67 ulp of S1.24 to the polynomial for |M| <= 1 + 2^-9. q >= 2 counts as 2.
class TaylorNormalizer {
 public:
  static constexpr UnitContract kContract = {"taylor_normalizer",
                                             "normal",
                                             5,
                                             1,
                                             "normal S1.38",
                                             "normal S1.24, round to nearest",
                                             0.67,
                                             "lengths up to 1 + 2^-9, against the polynomial"};

  static PixelNormal Of(const std::array<Quantity, 3>& normal) {
    const int64_t factor = Factor(SquareSum(normal));
    PixelNormal unit;
    for (size_t i = 0; i < unit.size(); ++i) {
      const int64_t product = ShortenedRaw(normal[i]) * factor;  // S2.57
      unit[i] = PixelNormalComponent::FromRaw((product + (int64_t{1} << 32)) >> 33);
    }
    return unit;
  }

 private:
  // U1.27, of q in U4.60.
  static int64_t Factor(uint64_t square) {
    constexpr int64_t kOne = int64_t{1} << 28;
    const int64_t excess = std::min(static_cast<int64_t>(square >> 32) - kOne, kOne - 1);
    const int64_t sum = (int64_t{1} << 59) - excess * (int64_t{1} << 30) + 3 * excess * excess;
    return (sum + (int64_t{1} << 31)) >> 32;
  }
};

}  // namespace shading
