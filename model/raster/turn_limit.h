// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/shading_types.h"
#include "model/triangle_packet.h"

namespace shading {

// How far two normals of a triangle may turn apart so that a surface method stays within `tolerance`
// codes of exact Blinn-Phong of a linear normal, in degrees: a rule from the largest errors that a
// search found (docs/second_order.md), for triangles without a terminator where the method clamps
// before it fits. For kd = diffuse, ks = specular of the brightest channel and shininess n:
//
//   quad, quad-split   10 (T / (0.036 kd + 0.021 ks n^1.5))^(1/3)
//   gouraud            10 (T / (1.35 kd + 1.35 ks n))^(1/2)
//   quad-cosine        the larger of quad's angle and the one whose error 0.036 kd (s / 10)^3 +
//                      ks (s / s1)^3.2 reaches T, s1 = 22.5 (8 / max(n, 8))^0.21
//
// 180 for flat and the methods that interpolate normals: they are never subdivided.
double TurnLimitDegrees(Method method, const Material& material, double tolerance);

// The same as Subdivision takes it.
int64_t TurnLimit(Method method, const Material& material, Tolerance tolerance);

}  // namespace shading
