// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/raster/span_setup.sv: row start and first difference of the surfaces.
//
//   quad ...  I = x (Ax + Cy + D) + y (By + E) + F    paper 003 (9)
//             I(x+1) - I(x) = 2Ax + A + Cy + D        paper 003 (3)
//   gouraud   I = D x + E y + F
//   flat      I = F
//   quad-polynomial, quad-horner: the coefficients and the pixel themselves
//
// Coordinates from the triangle's origin. The hardware steps from row to row by differences in y;
// sums and products keep the low bits, 36 of an intensity's and 46 of a cosine's, so that gives the
// same and is exact whenever the result is in range. Fields that a method does not use are 0.
class SpanSetup {
 public:
  static constexpr UnitContract kContract = {
      "span_setup", "raster", 4, 1, "coefficients S9.26, S1.44, coordinates S12.0",
      "seed S9.26, S1.44", 0, "results in range"};

  // Cycles between two spans of the method, the second `rows` below the first; 0 for the first span
  // of a triangle.
  static constexpr int Steps(Method method, int rows) {
    return method == Method::kFlat || IsPointForm(method) || rows < 1 ? 1 : rows;
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
