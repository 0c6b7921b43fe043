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

inline constexpr double kRadius = ideal::Footprint::kRadius;

// A triangle and what the set-up makes of it.
struct FootprintCase {
  FrameState frame = SpanFrame(512, 512);
  TrianglePacket packet;
  TriangleGeometry geometry;
  FootprintSetup::Result result;

  bool Make(const TrianglePacket& triangle, const FootprintSetup& setup,
            const VertexWeights& weights = kNoPerspective) {
    packet = triangle;
    if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return false;
    result =
        setup.Of(packet, geometry, frame.materials[0], geometry.box_x, geometry.box_y, weights);
    return true;
  }
  ideal::Vector Offset(size_t k) const {
    const auto& normal = result.footprint.offset[k].normal;
    return {normal[0].ToReal(), normal[1].ToReal(), normal[2].ToReal()};
  }
};

inline ideal::Vector Difference(const ideal::Vector& a, const ideal::Vector& b) {
  return ideal::Sum(a, ideal::Scaled(-1, b));
}

// d(normal)/dx and d(normal)/dy, from the values one pixel apart.
template <typename Normal>
std::array<ideal::Vector, 2> Slopes(const Normal& field) {
  const ideal::Vector centre = field.Normal(256, 256);
  return {Difference(field.Normal(257, 256), centre), Difference(field.Normal(256, 257), centre)};
}

// Radians.
inline double AngleBetween(const ideal::Vector& a, const ideal::Vector& b) {
  const ideal::Vector u = ideal::Normalised(a), v = ideal::Normalised(b);
  const ideal::Vector gap = Difference(u, v);
  return std::sqrt(ideal::Dot(gap, gap));
}

}  // namespace shading
