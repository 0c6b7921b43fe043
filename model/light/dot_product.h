// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/light_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/light/dot_product.sv: N.D = Nx Dx + Ny Dy + Nz Dz of a pixel's normal and
// a direction of the frame. Products and sum are exact in 46 fraction bits, rounded once to S1.30,
// halves up, saturated at -2 and 2 - 2^-30: |error| <= 0.5 ulp of S1.30 for sums in between.
class DotProduct {
 public:
  static constexpr UnitContract kContract = {"dot_product",
                                             "light",
                                             2,
                                             1,
                                             "normal S1.24, vector S1.22",
                                             "cosine S1.30, round to nearest, saturate",
                                             0.5,
                                             "vectors whose dot product lies in -2..2 - 2^-30"};

  static Cosine Of(const PixelNormal& normal, const Vector3& vector) {
    constexpr int kExtra =
        PixelNormalComponent::kFraction + NormalComponent::kFraction - Cosine::kFraction;
    return RoundSaturateCosine(normal[0].raw() * vector[0].raw() +
                                   normal[1].raw() * vector[1].raw() +
                                   normal[2].raw() * vector[2].raw(),
                               kExtra);
  }
};

}  // namespace shading
