// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "model/light/light_types.h"
#include "model/normal/pixel_square.h"
#include "model/normal/reciprocal_sqrt.h"

namespace shading {

// Bit-exact model of rtl/normal/phong_direct.sv: N = M / |M| of one pixel.
//
// M.M of the components in S1.30, in U2.44, truncated; M 2^exponent in S2.28, truncated; N rounded
// to nearest. Direction error < 2^-24 for |M| >= 2^-9; length error < 2^-22.7 + 2^-29.1 / |M|.
// |M| < 2^-22 gives 0, |M| >= 2 counts as 2.
class PhongDirect {
 public:
  static constexpr UnitContract kContract = {"phong_direct",
                                             "normal",
                                             11,
                                             1,
                                             "normal S1.38",
                                             "normal S1.24, round to nearest",
                                             2.15,
                                             "components, lengths of 1/8 to 1 + 2^-9"};

  static PixelNormal Of(const std::array<Quantity, 3>& normal) {
    const uint64_t square = SquareSum(normal) >> 16;
    const ReciprocalRoot root = ReciprocalSqrt::Of(SquaredLength::FromRaw(
        static_cast<int64_t>(std::min(square, static_cast<uint64_t>(SquaredLength::kMaxRaw)))));
    PixelNormal unit;
    for (size_t i = 0; i < unit.size(); ++i) unit[i] = Scaled(normal[i], root);
    return unit;
  }

 private:
  static PixelNormalComponent Scaled(Quantity component, const ReciprocalRoot& root) {
    const int64_t scaled = (component.raw() * (int64_t{1} << root.exponent)) >> 10;  // S2.28
    const int64_t product = scaled * root.mantissa.raw();                            // S4.52
    return PixelNormalComponent::FromRaw((product + (int64_t{1} << 27)) >> 28);
  }
};

}  // namespace shading
