// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace shading::sim {

struct Vec3 {
  double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(double s, Vec3 v) { return {s * v.x, s * v.y, s * v.z}; }
inline double Dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 Cross(Vec3 a, Vec3 b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double Length(Vec3 v) { return std::hypot(v.x, v.y, v.z); }
inline Vec3 Normalize(Vec3 v) {
  const double length = Length(v);
  return {v.x / length, v.y / length, v.z / length};
}
inline bool IsFinite(Vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Rotates about the y axis, then about the x axis; radians, counter-clockwise seen from the tip.
inline Vec3 Rotate(Vec3 v, double yaw, double pitch) {
  const Vec3 t = {std::cos(yaw) * v.x + std::sin(yaw) * v.z, v.y,
                  std::cos(yaw) * v.z - std::sin(yaw) * v.x};
  return {t.x, std::cos(pitch) * t.y - std::sin(pitch) * t.z,
          std::sin(pitch) * t.y + std::cos(pitch) * t.z};
}

using Color = std::array<double, 3>;  // red, green, blue; linear, 0..1

// Coefficients for a white light of intensity 1. Shininess is n of (N.H)^n, 1..256.
struct SceneMaterial {
  Color ambient = {0.06, 0.06, 0.06};
  Color diffuse = {0.6, 0.6, 0.6};
  Color specular = {0.35, 0.35, 0.35};
  double shininess = 32;
};

struct SceneVertex {
  Vec3 position, normal;  // the normal is of unit length
};

// Counter-clockwise seen from outside.
struct SceneTriangle {
  std::array<int, 3> vertex = {0, 0, 0};
  int material = 0;
};

// World space, right-handed, y up.
struct Scene {
  std::string name;
  std::vector<SceneVertex> vertices;
  std::vector<SceneTriangle> triangles;
  std::vector<SceneMaterial> materials;
};

}  // namespace shading::sim
