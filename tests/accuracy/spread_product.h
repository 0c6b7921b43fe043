// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/accuracy/spread_error.h"

namespace shading::accuracy {

// Errors in codes over the pixels of one triangle, some 200 pixels a side.
struct ProductErrors {
  double closed_form = 0;  // the method's closed form against exact Phong
  double codes = 0;        // the displayed codes against exact Phong
  double unit = 0;         // the displayed codes against the method's closed form
  int64_t pixels = 0;
};

// What the search works with, carried through the product: the triangle with its normals, light and
// material quantised, by the closed forms of model/ideal and by FrontEnd and ShadingUnit. The point
// of the case is the centre of a pixel; a point on an edge is moved a quarter of a pixel inwards.
ProductErrors ProductErrorsOf(Method method, const SpreadLight& light, const SpreadCase& at);

}  // namespace shading::accuracy
