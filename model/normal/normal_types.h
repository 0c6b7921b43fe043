// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/fixed/fixed.h"

namespace shading {

// Twins of the typedefs in rtl/pkg/normal_pkg.sv. A quantity is what a recurrence interpolates: a
// component of the normal, or N.L and N.H.
using SpanNormalComponent = S<1, 30>;
using SpanNormal = std::array<SpanNormalComponent, 3>;  // normal at an end of a span
using Quantity = S<1, 38>;                              // component or cosine, in a recurrence
using LengthSquare = S<1, 44>;                          // |N|^2 of linearly interpolated normals
using AngleLimit = U<0, 30>;  // 1 - cos of the largest angle that a straight line may span

inline constexpr int kMaxLanes = 4;

// What a method of normal interpolation needs at the start of a span.
struct SetupKind {
  bool spherical = false;  // angle linear along the span; else the vector linear
  bool cosines = false;    // quantities N.L, N.H or N.V, 0; else x, y, z
  bool length = false;     // |N|^2 as well; not with spherical
};

// kappa = 4 sin^2(phi / 2) = mantissa 4^-exponent, for the angle phi from pixel to pixel; the
// exponent, 0..10, is the largest that keeps the mantissa <= 1.
struct Kappa {
  U<1, 28> mantissa;
  int exponent = 0;
};
inline constexpr int kMaxKappaExponent = 10;

struct QuantitySeed {
  Quantity first;       // s(0)
  Quantity difference;  // s(stride) - s(0)
};

struct LengthSeed {
  LengthSquare first;       // q(0)
  LengthSquare difference;  // q(stride) - q(0)
  LengthSquare curvature;   // second difference
};

using Angle = U<1, 40>;  // radians, [0, 2); sums wrap

// Span on a great circle, N(t) = start cos(t step) + side sin(t step), paper 000 (6). Twin of arc_t.
struct SpanArc {
  Angle step;        // from pixel to pixel
  SpanNormal start;  // Na
  SpanNormal side;   // Nk, a quarter of a turn ahead of Na
};

// Start of a span for the units that interpolate normals; the stride is the number of lanes, lane j
// starts at pixel j. Fields that a method does not use are 0.
struct NormalSeed {
  std::array<std::array<QuantitySeed, kMaxLanes>, 3> quantity;  // x, y, z; or N.L, N.H
  std::array<LengthSeed, kMaxLanes> length_square;              // phong-duff
  Kappa kappa;                                                  // of one stride
  std::array<Kappa, 2> step_kappa;  // of one and of two pixels: slerp-paper with 4 lanes
};

}  // namespace shading
