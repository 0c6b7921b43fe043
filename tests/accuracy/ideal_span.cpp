// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/ideal_span.h"

#include <cmath>

namespace shading::accuracy {

Real Dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Direction Combination(Real p, const Direction& a, Real q, const Direction& b) {
  return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}

Direction Unit(const Direction& v) {
  const Real length = std::sqrt(Dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}

Direction ToReal(const SpanNormal& normal) {
  return {normal[0].ToReal(), normal[1].ToReal(), normal[2].ToReal()};
}

Direction ToReal(const Vector3& vector) {
  return {vector[0].ToReal(), vector[1].ToReal(), vector[2].ToReal()};
}

void IdealSpan::Set(Ideal ideal, const std::array<SpanNormal, 2>& ends, int length) {
  weight_.resize(static_cast<size_t>(length));
  const Direction a = ToReal(ends[0]), b = ToReal(ends[1]);
  const size_t last = static_cast<size_t>(length) - 1;
  if (ideal == Ideal::kSlerp) {
    SetSlerp(Unit(a), Unit(b), last);
  } else {
    SetPhong(a, b, last);
  }
}

// The ends are neither equal nor opposed.
void IdealSpan::SetSlerp(const Direction& a, const Direction& b, size_t last) {
  const Direction sum = Combination(1, a, 1, b), difference = Combination(-1, a, 1, b);
  const Real half_angle =
      std::atan2(std::sqrt(Dot(difference, difference)), std::sqrt(Dot(sum, sum)));
  middle_ = Unit(sum);
  across_ = Unit(difference);
  for (size_t t = 0; 2 * t <= last; ++t) {
    const Real place = 1 - 2 * static_cast<Real>(t) / static_cast<Real>(last);
    const Real c = std::cos(place * half_angle), s = std::sin(place * half_angle);
    weight_[t] = {c, -s};
    weight_[last - t] = {c, s};
  }
}

void IdealSpan::SetPhong(const Direction& a, const Direction& b, size_t last) {
  middle_ = Combination(0.5L, a, 0.5L, b);
  across_ = Combination(-0.5L, a, 0.5L, b);
  const Real aa = Dot(across_, across_), am = Dot(across_, middle_), mm = Dot(middle_, middle_);
  for (size_t t = 0; t <= last; ++t) {
    const Real place = 2 * static_cast<Real>(t) / static_cast<Real>(last) - 1;
    const Real c = 1 / std::sqrt(mm + place * (2 * am + place * aa));
    weight_[t] = {c, place * c};
  }
}

}  // namespace shading::accuracy
