// SPDX-License-Identifier: Apache-2.0
#include "examples/virtual_platform/torus.h"

#include <cmath>

namespace example {
namespace {

using shading::NormalComponent;
using shading::Reflectance;

constexpr double kPi = 3.14159265358979;
constexpr int kAround = 50, kAcross = 20;  // quads

struct Vec {
  double x, y, z;  // x right, y up, z towards the viewer
};

shading::Vector3 Unit(Vec v) {
  const double length = std::hypot(v.x, v.y, v.z);
  return {NormalComponent::Round(v.x / length), NormalComponent::Round(v.y / length),
          NormalComponent::Round(v.z / length)};
}

Vec Tilt(Vec v) {
  const double c = std::cos(0.9), s = std::sin(0.9);
  return {v.x, c * v.y - s * v.z, s * v.y + c * v.z};
}

shading::Material Copper() {
  shading::Material material;
  const auto rgb = [](double r, double g, double b) {
    return shading::Rgb{Reflectance::Round(r), Reflectance::Round(g), Reflectance::Round(b)};
  };
  material.ambient = rgb(0.12, 0.06, 0.04);
  material.diffuse = rgb(0.65, 0.33, 0.18);
  material.specular = rgb(0.6, 0.55, 0.5);
  material.shininess = shading::Shininess::Round(24);
  return material;
}

void SetVertex(int around, int across, const shading::FrameState& frame, size_t corner,
               shading::TrianglePacket* packet) {
  const double u = 2 * kPi * around / kAround, v = 2 * kPi * across / kAcross;
  const Vec normal{std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v)};
  const Vec centre{0.65 * std::cos(u), 0.65 * std::sin(u), 0};
  const Vec p = Tilt({centre.x + 0.3 * normal.x, centre.y + 0.3 * normal.y, 0.3 * normal.z});
  packet->x[corner] = shading::ScreenCoord::Round(frame.width / 2.0 + p.x * frame.height / 2.0);
  packet->y[corner] = shading::ScreenCoord::Round(frame.height / 2.0 - p.y * frame.height / 2.0);
  packet->z[corner] = shading::VertexDepth::Round(0.5 - 0.4 * p.z);
  packet->n[corner] = Unit(Tilt(normal));
}

}  // namespace

shading::TriangleList Torus(int width, int height) {
  shading::TriangleList list;
  list.frame.width = width;
  list.frame.height = height;
  list.frame.light = Unit({-1, 1, 1.5});
  const double length = std::hypot(1.0, 1.0, 1.5);
  list.frame.half = Unit({-1 / length, 1 / length, 1.5 / length + 1});
  list.frame.view = Unit({0, 0, 1});
  list.frame.materials = {Copper()};

  // Two triangles a quad, counter-clockwise from outside.
  constexpr int kCorner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
  for (int i = 0; i < kAround * kAcross; ++i) {
    for (const auto& triangle : kCorner) {
      shading::TrianglePacket packet;
      for (size_t k = 0; k < 3; ++k) {
        SetVertex(i / kAcross + triangle[k][0], i % kAcross + triangle[k][1], list.frame, k,
                  &packet);
      }
      list.triangles.push_back(packet);
    }
  }
  return list;
}

}  // namespace example
