// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "model/shading_types.h"
#include "sim/stress/vectors.h"

namespace shading::stress {

// Any great circle: a unit vector and another at right angles to it.
struct GreatArc {
  Vector start, side;

  // From the first three operands: direction, and turn of the plane about it.
  static GreatArc Of(const Genes& g) {
    const Vector start = Direction(g[0], g[1]);
    const Vector other = std::abs(start[2]) < 0.8L ? Vector{0, 0, 1} : Vector{1, 0, 0};
    const Vector east = Unit(Cross(other, start)), north = Cross(start, east);
    const Real turn = 2 * kPi * static_cast<Real>(g[2]);
    Vector side;
    for (size_t i = 0; i < 3; ++i) side[i] = std::cos(turn) * east[i] + std::sin(turn) * north[i];
    return {start, side};
  }
  Vector At(Real angle) const {
    Vector v;
    for (size_t i = 0; i < 3; ++i) v[i] = std::cos(angle) * start[i] + std::sin(angle) * side[i];
    return v;
  }
};

inline SpanCommand SpanOf(const GreatArc& arc, Real turn, int length) {
  SpanCommand span;
  span.length = length;
  span.normal = {Rounded<SpanNormalComponent>(arc.start),
                 Rounded<SpanNormalComponent>(arc.At(turn))};
  return span;
}

// 2..most, even in the logarithm.
inline int PixelsOf(double gene, int most) {
  return static_cast<int>(std::lround(Geometric(2, most, gene)));
}

// The angle between the ends as they were rounded.
inline Real TurnBetween(const SpanCommand& span) {
  const Vector a = Unit(RealOf(span.normal[0])), b = Unit(RealOf(span.normal[1]));
  const Vector chord = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  return 2 * std::asin(std::sqrt(Dot(chord, chord)) / 2);
}

// Paper 000 (2) at a pixel of a span that turns by `turn`.
inline Vector SlerpAt(const SpanCommand& span, Real turn, int pixel) {
  const Vector a = RealOf(span.normal[0]), b = RealOf(span.normal[1]);
  const Real w = static_cast<Real>(pixel) / std::max(1, span.length - 1);
  const Real wa = turn == 0 ? 1 - w : std::sin((1 - w) * turn) / std::sin(turn);
  const Real wb = turn == 0 ? w : std::sin(w * turn) / std::sin(turn);
  return {wa * a[0] + wb * b[0], wa * a[1] + wb * b[1], wa * a[2] + wb * b[2]};
}

inline Real KappaReal(const Kappa& kappa, int narrow) {
  return std::ldexp(static_cast<Real>(Narrowed(kappa.mantissa.raw(), narrow)),
                    -28 - 2 * kappa.exponent);
}

// s(t) of s(t+1) = s(t) + d(t), d(t) = d(t-1) - kappa s(t) in real numbers, in closed form.
inline Real ExactRecurrence(int64_t first, int64_t difference, Real kappa, int t) {
  const Real s = static_cast<Real>(first), d = static_cast<Real>(difference);
  if (kappa == 0) return s + t * d;
  const Real phi = 2 * std::asin(std::sqrt(kappa) / 2);
  return s * std::cos(t * phi) + (d + s * kappa / 2) * std::sin(t * phi) / std::sin(phi);
}

}  // namespace shading::stress
