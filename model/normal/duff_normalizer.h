// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "model/light/cosine.h"
#include "model/normal/normal_types.h"
#include "model/normal/reciprocal_sqrt.h"

namespace shading {

// Bit-exact model of rtl/normal/duff_normalizer.sv: N.L and N.H of the linear normal M, Duff 1979.
//
//   N.L = M.L / sqrt(q),   N.H = M.H / sqrt(q),   q = |M|^2
//
// M.L 2^exponent in S2.30, truncated, saturated; cosines rounded to nearest, saturated.
// |error| < 87.2 ulp of S1.30 for |M.L|, |M.H| <= sqrt(q); an error dq of q adds dq / (2 q).
// q <= 0 gives 0.
class DuffNormalizer {
 public:
  static constexpr UnitContract kContract = {"duff_normalizer",
                                             "normal",
                                             9,
                                             1,
                                             "M.L and M.H S1.38, q S1.44",
                                             "cosines S1.30, round to nearest, saturate",
                                             87.2,
                                             "q > 0, dot products up to the square root of q"};

  static LightCosines Of(Quantity n_dot_l, Quantity n_dot_h_or_v, LengthSquare q) {
    const ReciprocalRoot root =
        ReciprocalSqrt::Of(SquaredLength::FromRaw(std::max<int64_t>(q.raw(), 0)));
    return {Scaled(n_dot_l, root), Scaled(n_dot_h_or_v, root)};
  }

 private:
  static Cosine Scaled(Quantity dot, const ReciprocalRoot& root) {
    constexpr int64_t kLimit = int64_t{1} << 32;
    const int64_t wide = (dot.raw() * (int64_t{1} << root.exponent)) >> 8;
    const int64_t scaled = std::clamp(wide, -kLimit, kLimit - 1);  // S2.30
    return RoundSaturateCosine(scaled * root.mantissa.raw(), 24);  // of S3.54
  }
};

}  // namespace shading
