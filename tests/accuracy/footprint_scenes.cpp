// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "sim/scene/shapes.h"
#include "tests/accuracy/footprint_flicker.h"

namespace shading::accuracy {
namespace {

using sim::Vec3;
constexpr double kDegree = 3.14159265358979323846 / 180;

// A flat square in z = 0 whose normals swing by `lean` degrees about x from row to row.
sim::Scene Ribs(int ribs, double lean) {
  constexpr int kColumns = 8;
  sim::Scene scene;
  for (int row = 0; row <= 2 * ribs; ++row) {
    const double slope = std::tan((row % 2 == 0 ? -lean : lean) * kDegree);
    for (int column = 0; column <= kColumns; ++column) {
      const Vec3 position = {2.0 * column / kColumns - 1, 1.0 * row / ribs - 1, 0};
      scene.vertices.push_back({position, sim::Normalize({0, slope, 1})});
    }
  }
  for (int row = 0; row < 2 * ribs; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int a = row * (kColumns + 1) + column, d = a + kColumns + 1;
      scene.triangles.push_back({{a, a + 1, d + 1}, 0});
      scene.triangles.push_back({{a, d + 1, d}, 0});
    }
  }
  return scene;
}

sim::SceneMaterial Gloss(sim::Color diffuse) {
  sim::SceneMaterial material;
  material.diffuse = diffuse;
  for (size_t c = 0; c < 3; ++c) material.ambient[c] = 0.1 * diffuse[c];
  material.specular = {0.7, 0.7, 0.7};
  material.shininess = 128;
  return material;
}

// A turntable seen from `elevation` degrees above it. The light is the mirror image of the viewer,
// so that the half vector is the table's axis, and highlights stay where normals point upwards.
sim::ViewOptions Turntable(int size, double elevation, double yaw) {
  sim::ViewOptions view;
  view.width = view.height = size;
  view.yaw = yaw;
  view.pitch = elevation;
  const double s = std::sin(elevation * kDegree), c = std::cos(elevation * kDegree);
  view.light = {0, 2 * s * c, 2 * s * s - 1};
  return view;
}

}  // namespace

std::vector<Turning> SlantedScenes() {
  Turning plane = {"ribbed plane", {}, Turntable(96, 25, 20), 0.2};
  plane.view.perspective = true;
  sim::Append(Ribs(5, 40), {1, 0, -90, {}}, Gloss({0.12, 0.25, 0.45}), &plane.scene);
  Turning cylinder = {"cylinder", {}, Turntable(32, 30, 35), 0.2};
  sim::Append(sim::Cylinder(12), {1, 0, 90, {}}, Gloss({0.50, 0.20, 0.10}), &cylinder.scene);
  Turning large = {"large cylinder", cylinder.scene, Turntable(96, 30, 35), 0.2};
  for (Turning* turning : {&plane, &cylinder, &large}) turning->scene.name = turning->name;
  return {plane, cylinder, large};
}

}  // namespace shading::accuracy
