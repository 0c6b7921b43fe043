// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/raster/span_setup.sv: row start and first difference of three channels.
//
//   quad      I = x (Ax + Cy + D) + y (By + E) + F    paper 003 (9)
//             I(x+1) - I(x) = 2Ax + A + Cy + D        paper 003 (3)
//   gouraud   I = D x + E y + F
//   flat      I = F
//
// Coefficients S9.26, coordinates from the triangle's origin. Sums and products keep the low 36
// bits, so the result is exact whenever it lies in S9.26. Fields that a method does not use are 0.
class SpanSetup {
 public:
  static constexpr UnitContract kContract = {
      "span_setup",      "raster", 7, 5, "coefficients S9.26, coordinates S12.0", "seed S9.26", 0,
      "results in S9.26"};

  // Products of one span, and cycles between two spans of the method: one of intensities.
  static constexpr int Steps(Method method) {
    return method == Method::kQuad ? 5 : method == Method::kGouraud ? 2 : 1;
  }

  static void Seed(Method method, const TriangleState& triangle, const SpanCommand& span,
                   SpanSeed* seed);
  static SpanSeed Seed(Method method, const TriangleState& triangle, const SpanCommand& span) {
    SpanSeed seed;
    Seed(method, triangle, span, &seed);
    return seed;
  }
};

}  // namespace shading
