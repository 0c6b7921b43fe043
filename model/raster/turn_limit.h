// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/shading_types.h"
#include "model/triangle_packet.h"

namespace shading {

// How far two normals of a triangle may turn apart so that a surface method stays within
// `tolerance` codes of exact Blinn-Phong of a linear normal, in degrees: a rule on the safe side of
// the largest errors that a search found (docs/second_order.md). It holds where N.L >= 0 and
// N.H >= 0, and for gouraud and quad, which clamp before they fit, where the light stays below full
// scale. For kd = diffuse, ks = specular of the brightest channel and shininess n:
//
//   quad, quad-split   10 (T / (0.036 kd + h ks))^(1/3),  h = max(0.043 n, 0.0218 n^1.5)
//   gouraud            10 (T / (1.35 kd + 1.35 ks n))^(1/2)
//   quad-cosine        the larger of quad's angle and the one whose error 0.036 kd (s / 10)^3 +
//                      ks (s / s1)^p reaches T, s1 = 22.5 (8 / max(n, 8))^0.21, p = 3.2, and 4
//                      above s1
//
//   footprint-paper    30: then two of its enlarged normals are at most 90 degrees apart
//
// At most 75, for the errors rise faster beyond. 180 where T is more than the light itself, and for
// flat and the other methods that interpolate normals: they are never subdivided.
double TurnLimitDegrees(Method method, const Material& material, double tolerance);

// The same as Subdivision takes it: the square of the chord, in 2^-44. The angle is rounded down to
// 2^-10 degrees and the square to 2^-28, so the last bits of a C library's pow and sin do not show.
// Never reached where the angle is 180.
int64_t TurnLimit(Method method, const Material& material, Tolerance tolerance);

}  // namespace shading
