// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "model/triangle_packet.h"
#include "sim/stress/check.h"

namespace shading::stress {

using Vector = std::array<Real, 3>;

inline Vector Direction(double turn, double height) {
  const Real z = 2 * static_cast<Real>(height) - 1, r = std::sqrt(1 - z * z);
  return {r * std::cos(2 * kPi * turn), r * std::sin(2 * kPi * turn), z};
}
inline Real Dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector Cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vector Unit(const Vector& v) {
  const Real length = std::sqrt(Dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}
template <typename Fixed>
std::array<Fixed, 3> Rounded(const Vector& v) {
  std::array<Fixed, 3> fixed;
  for (size_t i = 0; i < 3; ++i) fixed[i] = Fixed::Wrap(RoundTo(v[i], Fixed::kFraction));
  return fixed;
}
template <typename Fixed>
Vector RealOf(const std::array<Fixed, 3>& fixed) {
  Vector v;
  for (size_t i = 0; i < 3; ++i)
    v[i] = std::ldexp(static_cast<Real>(fixed[i].raw()), -Fixed::kFraction);
  return v;
}
template <typename Fixed>
double Farthest(const std::array<Fixed, 3>& actual, const Vector& ideal, int narrow) {
  Real worst = 0;
  for (size_t i = 0; i < 3; ++i) {
    Raise(&worst, std::abs(static_cast<Real>(Narrowed(actual[i].raw(), narrow)) -
                           std::ldexp(ideal[i], Fixed::kFraction)));
  }
  return static_cast<double>(worst);
}

}  // namespace shading::stress
