// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <ostream>
#include <random>

#include "model/triangle_packet.h"

namespace shading {

inline Vector3 Quantised(double x, double y, double z) {
  const double scale = 1 / std::sqrt(x * x + y * y + z * z);
  return {NormalComponent::Round(x * scale), NormalComponent::Round(y * scale),
          NormalComponent::Round(z * scale)};
}

inline Vector3 RandomNormal(std::mt19937& random) {
  std::normal_distribution<double> gauss;
  const double x = gauss(random), y = gauss(random), z = gauss(random);
  return Quantised(x, y, z);
}

// A unit vector at an angle of the order of `spread` radians from `centre`.
inline Vector3 Near(const Vector3& centre, double spread, std::mt19937& random) {
  std::normal_distribution<double> gauss(0, spread);
  const double x = gauss(random), y = gauss(random), z = gauss(random);
  return Quantised(centre[0].ToReal() + x, centre[1].ToReal() + y, centre[2].ToReal() + z);
}

// How gtest names it.
inline void PrintTo(Lighting lighting, std::ostream* out) {
  *out << (lighting == Lighting::kBlinn ? "Blinn" : "Phong");
}

}  // namespace shading
