// SPDX-License-Identifier: Apache-2.0
#include "tb/stimulus/random_triangles.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace shading::tb {
namespace {

constexpr int64_t kPixel = int64_t{1} << ScreenCoord::kFraction;

struct Point {
  int64_t x = 0, y = 0;
};
using Direction = std::array<double, 3>;

class Generator {
 public:
  explicit Generator(uint32_t seed) : random_(seed) {
    DrawFrame();
    // Half of the frames have perspective; drawn apart, for the triangles are those of the seed.
    std::mt19937 slope(seed + 1);
    if (slope() % 2 == 0) frame_.depth_slope = DepthSlope::FromRaw(slope() & DepthSlope::kMaxRaw);
  }

  TrianglePacket Next() {
    TrianglePacket packet;
    const std::array<Point, 3> corner = Corners();
    const std::array<Direction, 3> normal = Normals();
    for (size_t i = 0; i < 3; ++i) {
      packet.x[i] = Guarded(corner[i].x);
      packet.y[i] = Guarded(corner[i].y);
      packet.z[i] = VertexDepth::FromRaw(Integer(0, VertexDepth::kMaxRaw));
      packet.n[i] = Quantise(normal[i]);
    }
    packet.material =
        static_cast<int>(Integer(0, static_cast<int64_t>(frame_.materials.size()) - 1));
    last_ = corner;
    return packet;
  }

  const FrameState& frame() const { return frame_; }

 private:
  int64_t Integer(int64_t low, int64_t high) {
    return std::uniform_int_distribution<int64_t>(low, high)(random_);
  }
  double Real(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool OneIn(int n) { return Integer(1, n) == 1; }

  static ScreenCoord Guarded(int64_t raw) {
    constexpr int64_t kLimit = int64_t{1} << (ScreenCoord::kWidth - 1);
    return ScreenCoord::FromRaw(std::clamp(raw, -kLimit, kLimit - 1));
  }
  static Vector3 Quantise(Direction v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    for (double& c : v) c /= length;
    return {NormalComponent::Round(v[0]), NormalComponent::Round(v[1]),
            NormalComponent::Round(v[2])};
  }

  Direction AnyDirection() {
    Direction v;
    do {
      for (double& c : v) c = Real(-1, 1);
    } while (std::hypot(v[0], v[1], v[2]) < 0.1);
    return v;
  }

  void DrawFrame() {
    static constexpr std::array<std::array<int, 2>, 6> kScreens = {
        {{320, 240}, {64, 48}, {640, 200}, {4096, 16}, {16, 4096}, {2048, 40}}};
    const auto& screen = kScreens[static_cast<size_t>(Integer(0, 5))];
    frame_.width = screen[0];
    frame_.height = screen[1];
    Direction light = AnyDirection();
    light[2] = std::abs(light[2]) + 0.1;
    frame_.light = Quantise(light);
    frame_.view = Quantise({0, 0, 1});
    const double length = std::hypot(light[0], light[1], light[2]);
    frame_.half = Quantise({light[0] / length, light[1] / length, light[2] / length + 1});
    frame_.lighting = OneIn(4) ? Lighting::kPhong : Lighting::kBlinn;
    frame_.cull = OneIn(3) ? Cull::kNone : Cull::kBack;
    for (int i = 0; i < 8; ++i) frame_.materials.push_back(DrawMaterial());
  }

  Material DrawMaterial() {
    static constexpr std::array<double, 6> kShininess = {1, 8, 32, 128, 256, 20.3};
    const auto color = [&](int zero_in) {
      Rgb rgb;
      for (Reflectance& c : rgb) c = Reflectance::Round(OneIn(zero_in) ? 0 : Real(0, 1));
      return rgb;
    };
    Material material;
    material.ambient = color(2);
    material.diffuse = color(6);
    material.specular = color(3);
    material.shininess = Shininess::Round(kShininess[static_cast<size_t>(Integer(0, 5))]);
    return material;
  }

  Point Anywhere() {
    return {Integer(-20, frame_.width * kPixel + 20), Integer(-20, frame_.height * kPixel + 20)};
  }
  Point Near(Point p, int64_t reach) {
    return {p.x + Integer(-reach, reach), p.y + Integer(-reach, reach)};
  }
  static Point OnCentre(Point p) {
    return {p.x / kPixel * kPixel + kPixel / 2, p.y / kPixel * kPixel + kPixel / 2};
  }

  std::array<Point, 3> Corners() {
    const Point a = Anywhere();
    switch (Integer(0, 11)) {
      case 0: return {a, Near(a, kPixel), Near(a, kPixel)};  // about one pixel
      case 1: return {a, Near(a, 2), Anywhere()};            // needle
      case 2: return Sliver(a, Anywhere());
      case 3: return {last_[1], last_[0], Near(last_[0], 40 * kPixel)};  // shared edge
      case 4: return {last_[2], last_[1], Near(last_[1], 9 * kPixel)};
      case 5: {  // vertices on centres
        const Point b = OnCentre(a);
        return {b, OnCentre(Near(b, 20 * kPixel)), OnCentre(Near(b, 20 * kPixel))};
      }
      case 6: return OneIn(8) ? Huge() : std::array<Point, 3>{a, Near(a, 3000), Near(a, 3000)};
      case 7: {  // flat on one side
        const Point b{a.x + Integer(1, 40 * kPixel), a.y};
        return {a, b, Near(a, 20 * kPixel)};
      }
      case 8:
        return OneIn(4) ? std::array<Point, 3>{a, a, Anywhere()}  // zero area
                        : std::array<Point, 3>{a, Near(a, 600), Near(a, 600)};
      default: return {a, Near(a, 12 * kPixel), Near(a, 12 * kPixel)};
    }
  }

  // The third corner lies a few 1/256 pixels beside the line through the other two.
  std::array<Point, 3> Sliver(Point a, Point b) {
    const double t = Real(0, 1);
    const Point c{a.x + std::llround(t * static_cast<double>(b.x - a.x)),
                  a.y + std::llround(t * static_cast<double>(b.y - a.y))};
    return {a, b, Near(c, 3)};
  }
  std::array<Point, 3> Huge() {
    constexpr int64_t kFar = 8191 * kPixel;
    std::array<Point, 3> corner;
    for (Point& p : corner) p = {Integer(-kFar, kFar), Integer(-kFar, kFar)};
    return corner;
  }

  std::array<Direction, 3> Normals() {
    const Direction n = AnyDirection();
    const auto beside = [&](double reach) {
      return Direction{n[0] + Real(-reach, reach), n[1] + Real(-reach, reach),
                       n[2] + Real(-reach, reach)};
    };
    const Direction opposed = {-n[0], -n[1], -n[2]};
    switch (Integer(0, 5)) {
      case 0: return {n, n, n};
      case 1: return {n, beside(1e-3), beside(1e-6)};
      case 2: return {n, opposed, AnyDirection()};
      case 3: return {n, beside(0.05), {opposed[0] + 0.01, opposed[1], opposed[2]}};
      case 4: return {n, AnyDirection(), AnyDirection()};
      default: return {n, beside(0.05), beside(0.05)};
    }
  }

  std::mt19937 random_;
  FrameState frame_;
  std::array<Point, 3> last_;
};

}  // namespace

TriangleList RandomTriangles(uint32_t seed, int count) {
  Generator generator(seed);
  TriangleList list;
  list.frame = generator.frame();
  list.triangles.reserve(static_cast<size_t>(count));
  for (int i = 0; i < count; ++i) list.triangles.push_back(generator.Next());
  return list;
}

}  // namespace shading::tb
