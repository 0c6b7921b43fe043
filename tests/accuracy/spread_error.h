// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/ideal/lighting.h"
#include "model/shading_types.h"

namespace shading::accuracy {

// Which light is looked at, in parts of full scale.
struct SpreadLight {
  double diffuse = 0, specular = 0;  // kd, ks
  int shininess = 1;
  // Only triangles without a terminator: N.L >= 0 and N.H >= 0 in the whole triangle. Where the
  // light and the viewer are on the same side as the normal, so is H.
  bool lit = true;
};

// A triangle in the space of normals, a light and a point: all that the error depends on. The
// screen only says which pixels there are.
struct SpreadCase {
  std::array<ideal::Vector, 3> normal;  // unit
  ideal::Vector light, half;            // unit
  std::array<double, 3> weight;         // barycentric, 0..1
};

struct SpreadCodes {
  double exact = 0, shown = 0;  // 255 = full scale, not rounded
};

// Exact Blinn-Phong of the linear normal, and what a surface method shows, in double:
//
//   exact         kd max(0, N.L) + ks max(0, N.H)^n,  N = sum w_i N_i, normalised
//   gouraud       line through this light of the corners
//   quad          quadratic through it at the corners and the middles of the edges
//   quad-split    max(0, quadratic through kd N.L) + max(0, quadratic through ks (N.H)^n)
//   quad-cosine   the light of quadratics through N.L and N.H
//
// All are clamped to full scale, where kd + ks <= 1. Where it is more they are not: then the light
// of a triangle that stays below full scale is what is looked at.
SpreadCodes CodesOf(Method method, const SpreadLight& light, const SpreadCase& at);

// |shown - exact|; -1 where light.lit excludes the triangle.
double SpreadError(Method method, const SpreadLight& light, const SpreadCase& at);

}  // namespace shading::accuracy
