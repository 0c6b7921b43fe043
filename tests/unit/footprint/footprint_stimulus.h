// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <random>

#include "model/footprint/footprint_setup.h"
#include "model/ideal/footprint.h"
#include "tests/unit/normal/normal_triangle_stimulus.h"

namespace shading {

// A triangle of about `size` pixels around the middle of the screen, anywhere between pixels.
inline std::array<double, 6> RandomCorners(double size, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::array<double, 6> at;
  do {
    for (double& c : at) c = 256 + size * uniform(random);
  } while (std::abs((at[2] - at[0]) * (at[5] - at[1]) - (at[4] - at[0]) * (at[3] - at[1])) <
           0.1 * size * size);
  return at;
}

inline TrianglePacket PacketAt(const std::array<double, 6>& at) {
  TrianglePacket packet;
  for (size_t i = 0; i < 3; ++i) {
    packet.x[i] = ScreenCoord::Round(at[2 * i]);
    packet.y[i] = ScreenCoord::Round(at[2 * i + 1]);
  }
  return packet;
}

// Normals at most `spread` radians from one another.
inline std::array<Vector3, 3> NormalsWithin(double spread, std::mt19937& random) {
  const Vector3 n = RandomNormal(random);
  return {Near(n, spread / 2, random), Near(n, spread / 2, random), Near(n, spread / 2, random)};
}

inline FootprintSetup SetupOf(FootprintForm form, FootprintPattern pattern) {
  FootprintSetup::Options options;
  options.form = form;
  options.least = options.most = pattern;
  return FootprintSetup(options);
}

}  // namespace shading
