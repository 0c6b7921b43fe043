// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/shapes.h"

namespace shading::sim {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Corners a, b, c, d counter-clockwise.
void AddQuad(int a, int b, int c, int d, Scene* scene) {
  scene->triangles.push_back({{a, b, c}, 0});
  scene->triangles.push_back({{a, c, d}, 0});
}

// The quads of a grid of n + 1 rows of n + 1 vertices.
void AddGrid(int n, Scene* scene) {
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i;
      const int d = a + n + 1;
      AddQuad(a, a + 1, d + 1, d, scene);
    }
  }
}

}  // namespace

Scene Triangle(int n) {
  const std::array<Vec3, 3> corner = {{{-1.0, -0.7, 0.1}, {1.0, -0.8, -0.1}, {0.1, 1.0, -0.2}}};
  const std::array<Vec3, 3> normal = {
      {Normalize({-0.45, -0.35, 0.8}), Normalize({0.6, -0.2, 0.8}), Normalize({0.15, 0.7, 0.7})}};
  Scene scene;
  // Row r has r + 1 vertices and starts at r (r + 1) / 2; row 0 is the third corner.
  for (int row = 0; row <= n; ++row) {
    for (int i = 0; i <= row; ++i) {
      const double w1 = static_cast<double>(i) / n;
      const double w0 = static_cast<double>(row - i) / n;
      const double w2 = static_cast<double>(n - row) / n;
      scene.vertices.push_back({w0 * corner[0] + w1 * corner[1] + w2 * corner[2],
                                Normalize(w0 * normal[0] + w1 * normal[1] + w2 * normal[2])});
    }
  }
  for (int row = 0; row < n; ++row) {
    const int upper = row * (row + 1) / 2;
    const int lower = upper + row + 1;
    for (int i = 0; i <= row; ++i) {
      scene.triangles.push_back({{lower + i, lower + i + 1, upper + i}, 0});
      if (i < row) scene.triangles.push_back({{lower + i + 1, upper + i + 1, upper + i}, 0});
    }
  }
  return scene;
}

Scene Sphere(int n) {
  Scene scene;
  scene.vertices.push_back({{0, 1, 0}, {0, 1, 0}});
  for (int band = 1; band < n; ++band) {
    const double theta = kPi * band / n;
    for (int j = 0; j < 2 * n; ++j) {
      const double phi = kPi * j / n;
      const Vec3 p = {std::sin(theta) * std::sin(phi), std::cos(theta),
                      std::sin(theta) * std::cos(phi)};
      scene.vertices.push_back({p, Normalize(p)});
    }
  }
  scene.vertices.push_back({{0, -1, 0}, {0, -1, 0}});

  const int south = static_cast<int>(scene.vertices.size()) - 1;
  for (int j = 0; j < 2 * n; ++j) {
    const int next = (j + 1) % (2 * n);
    scene.triangles.push_back({{0, 1 + j, 1 + next}, 0});
    for (int band = 1; band + 1 < n; ++band) {
      const int upper = 1 + (band - 1) * 2 * n;
      const int lower = upper + 2 * n;
      AddQuad(upper + j, lower + j, lower + next, upper + next, &scene);
    }
    const int last = south - 2 * n;
    scene.triangles.push_back({{last + j, south, last + next}, 0});
  }
  return scene;
}

Scene Torus(int n) {
  constexpr double kTube = 0.4;
  Scene scene;
  for (int ring = 0; ring < n; ++ring) {
    const double phi = 2 * kPi * ring / n;
    for (int side = 0; side < n; ++side) {
      const double psi = 2 * kPi * side / n;
      const Vec3 outwards = {std::cos(phi), std::sin(phi), 0};
      const Vec3 normal = std::cos(psi) * outwards + Vec3{0, 0, std::sin(psi)};
      scene.vertices.push_back({outwards + kTube * normal, Normalize(normal)});
    }
  }
  for (int ring = 0; ring < n; ++ring) {
    const int here = ring * n;
    const int there = (ring + 1) % n * n;
    for (int side = 0; side < n; ++side) {
      const int next = (side + 1) % n;
      AddQuad(here + side, there + side, there + next, here + next, &scene);
    }
  }
  return scene;
}

Scene Saddle(int n) {
  Scene scene;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n - 1;
      const double y = 2.0 * j / n - 1;
      scene.vertices.push_back({{x, y, x * y / 2}, Normalize({-y / 2, -x / 2, 1})});
    }
  }
  AddGrid(n, &scene);
  return scene;
}

Scene Panel(int n) {
  const double lean = std::tan(20 * kPi / 180);
  Scene scene;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = 2.0 * i / n - 1;
      const double y = 2.0 * j / n - 1;
      scene.vertices.push_back({{x, y, 0}, Normalize({lean * x, lean * y, 1})});
    }
  }
  AddGrid(n, &scene);
  return scene;
}

Scene Cylinder(int n) {
  constexpr double kRadius = 0.25;
  Scene scene;
  for (int ring = 0; ring <= n; ++ring) {
    for (int side = 0; side < n; ++side) {
      const double phi = 2 * kPi * side / n;
      const Vec3 normal = {std::sin(phi), 0, std::cos(phi)};
      scene.vertices.push_back({kRadius * normal + Vec3{0, 2.0 * ring / n - 1, 0}, normal});
    }
  }
  for (int ring = 0; ring < n; ++ring) {
    for (int side = 0; side < n; ++side) {
      const int next = (side + 1) % n;
      AddQuad(ring * n + side, ring * n + next, (ring + 1) * n + next, (ring + 1) * n + side,
              &scene);
    }
  }
  return scene;
}

void Append(const Scene& part, const Placement& placement, const SceneMaterial& material,
            Scene* scene) {
  const int first = static_cast<int>(scene->vertices.size());
  const int material_index = static_cast<int>(scene->materials.size());
  const double yaw = placement.yaw * kPi / 180;
  const double pitch = placement.pitch * kPi / 180;
  for (const SceneVertex& v : part.vertices) {
    scene->vertices.push_back({placement.scale * Rotate(v.position, yaw, pitch) + placement.offset,
                               Rotate(v.normal, yaw, pitch)});
  }
  for (const SceneTriangle& t : part.triangles) {
    scene->triangles.push_back(
        {{first + t.vertex[0], first + t.vertex[1], first + t.vertex[2]}, material_index});
  }
  scene->materials.push_back(material);
}

}  // namespace shading::sim
