// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/normal/normal_types.h"
#include "model/triangle_packet.h"

namespace shading::accuracy {

using Real = long double;
using Direction = std::array<Real, 3>;

Real Dot(const Direction& a, const Direction& b);
Direction Combination(Real p, const Direction& a, Real q, const Direction& b);
Direction Unit(const Direction& v);
Direction ToReal(const SpanNormal& normal);
Direction ToReal(const Vector3& vector);

// What a method is compared with, in closed form.
enum class Ideal {
  kSlerp,  // paper 000 (2) between the unit vectors along the ends
  kPhong   // the vector linear between the ends, normalised
};

// The normals of a span's pixels, w = t / (length - 1) from end to end:
//
//   N(t) = middle c(t) + across s(t)
//   kSlerp   middle and across unit, c = cos((w - 1/2) psi), s = sin((w - 1/2) psi)
//   kPhong   middle = (Na + Nb)/2, across = (Nb - Na)/2, c = 1/|N|, s = (2 w - 1)/|N|
class IdealSpan {
 public:
  void Set(Ideal ideal, const std::array<SpanNormal, 2>& ends, int length);

  // Cosines N(t).direction.
  struct Row {
    Real along_middle, along_across;
    const std::vector<std::array<Real, 2>>* weight;
    Real At(size_t t) const {
      return along_middle * (*weight)[t][0] + along_across * (*weight)[t][1];
    }
  };
  Row Cosines(const Vector3& direction) const {
    const Direction d = ToReal(direction);
    return {Dot(middle_, d), Dot(across_, d), &weight_};
  }

 private:
  void SetSlerp(const Direction& a, const Direction& b, size_t last);
  void SetPhong(const Direction& a, const Direction& b, size_t last);

  Direction middle_ = {}, across_ = {};
  std::vector<std::array<Real, 2>> weight_;  // c, s of pixel t
};

// Cosine clamped to [0, 1] to the power of n, a power of 2.
inline Real IdealIntensity(Real cosine, int n) {
  Real power = cosine < 0 ? 0 : cosine > 1 ? 1 : cosine;
  for (; n > 1; n /= 2) power *= power;
  return power;
}

}  // namespace shading::accuracy
