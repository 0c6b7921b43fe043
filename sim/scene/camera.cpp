// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "model/shading_types.h"

namespace shading::sim {
namespace {

constexpr double kRadians = 3.14159265358979323846 / 180;
constexpr double kFill = 0.95;  // of the shorter side; the rest is margin
constexpr double kHalfFieldOfView = 22.5 * kRadians;
constexpr double kGuardBand = 8192;  // pixels

struct BoundingSphere {
  Vec3 center;
  double radius = 0;
};

// Of the triangles' vertices, about the centre of their bounding box: at most sqrt(3) times the
// smallest sphere, and as small as possible for what reaches equally far to both sides.
BoundingSphere Bound(const Scene& scene) {
  const auto position = [&](int v) { return scene.vertices[static_cast<size_t>(v)].position; };
  Vec3 low = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  Vec3 high = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
  for (const SceneTriangle& t : scene.triangles) {
    for (const int v : t.vertex) {
      const Vec3 p = position(v);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  BoundingSphere sphere{0.5 * low + 0.5 * high, 0};
  for (const SceneTriangle& t : scene.triangles) {
    for (const int v : t.vertex) {
      sphere.radius = std::max(sphere.radius, Length(position(v) - sphere.center));
    }
  }
  if (!(sphere.radius > 0)) sphere.radius = 1;  // a single point: any scale will do
  return sphere;
}

// Pixels and depth of a point, camera space, in units of the bounding sphere's radius.
class Projection {
 public:
  explicit Projection(const ViewOptions& options)
      : perspective_(options.perspective),
        center_x_(options.width / 2.0),
        center_y_(options.height / 2.0) {
    const double half_side = kFill * std::min(options.width, options.height) / 2.0;
    scale_ = half_side;
    if (perspective_) {
      scale_ = center_y_ / std::tan(kHalfFieldOfView);
      // The sphere touches the cone whose half angle sees half_side pixels.
      distance_ = 1 / std::sin(std::atan2(half_side, scale_));
    }
  }

  // 1 / distance of depth z is in proportion to 1 - slope z.
  double depth_slope() const { return perspective_ ? 2 / (distance_ + 1) : 0; }

  Vec3 operator()(Vec3 p) const {
    if (!perspective_) return {center_x_ + scale_ * p.x, center_y_ - scale_ * p.y, (1 - p.z) / 2};
    // 1 / distance is affine on the screen, so depth is made of it.
    const double away = distance_ - p.z;
    const double near = distance_ - 1;
    const double far = distance_ + 1;
    return {center_x_ + scale_ * p.x / away, center_y_ - scale_ * p.y / away,
            far * (away - near) / (away * (far - near))};
  }

 private:
  bool perspective_;
  double center_x_, center_y_;
  double scale_ = 1;     // pixels per radius; perspective: at unit distance
  double distance_ = 0;  // of the viewer from the centre
};

Vector3 RoundUnit(Vec3 v) {
  return {NormalComponent::Round(v.x), NormalComponent::Round(v.y), NormalComponent::Round(v.z)};
}

Rgb RoundColor(const Color& color) {
  Rgb rounded;
  for (size_t c = 0; c < 3; ++c) rounded[c] = Reflectance::Round(std::clamp(color[c], 0.0, 1.0));
  return rounded;
}

void CheckOptions(const ViewOptions& options) {
  for (const int side : {options.width, options.height}) {
    if (side < 1 || side > kMaxScreen) {
      throw std::runtime_error(fmt::format("size {}x{}: width and height must be 1 to {} pixels",
                                           options.width, options.height, kMaxScreen));
    }
  }
  if (!std::isfinite(options.yaw) || !std::isfinite(options.pitch)) {
    throw std::runtime_error("rotation: yaw and pitch must be finite numbers of degrees");
  }
  if (const double length = Length(options.light); !std::isfinite(length) || !(length > 0)) {
    throw std::runtime_error(
        fmt::format("light {},{},{}: has no direction; give a vector of "
                    "finite numbers that are not all zero",
                    options.light.x, options.light.y, options.light.z));
  }
}

FrameState MakeFrame(const Scene& scene, const ViewOptions& options) {
  const Vec3 view = {0, 0, 1};
  const Vec3 light = Normalize(options.light);
  const Vec3 sum = light + view;
  if (Length(sum) < 1e-6) {
    throw std::runtime_error(
        fmt::format("light {},{},{}: lies exactly behind the scene, where "
                    "light and viewer have no half vector; tilt it a little",
                    options.light.x, options.light.y, options.light.z));
  }
  FrameState frame;
  frame.width = options.width;
  frame.height = options.height;
  frame.light = RoundUnit(light);
  frame.half = RoundUnit(Normalize(sum));
  frame.view = RoundUnit(view);
  frame.lighting = options.lighting;
  frame.cull = options.cull;
  frame.depth_slope = DepthSlope::Round(Projection(options).depth_slope());
  for (const SceneMaterial& m : scene.materials) {
    frame.materials.push_back({RoundColor(m.ambient), RoundColor(m.diffuse), RoundColor(m.specular),
                               Shininess::Round(std::clamp(m.shininess, 1.0, 256.0))});
  }
  return frame;
}

// A vertex of the scene in the unit's formats.
struct ScreenVertex {
  ScreenCoord x, y;
  VertexDepth z;
  Vector3 n;
};

// Only what triangles use: a stray vertex may lie anywhere.
std::vector<bool> UsedVertices(const Scene& scene) {
  std::vector<bool> used(scene.vertices.size());
  for (const SceneTriangle& t : scene.triangles) {
    for (const int v : t.vertex) used[static_cast<size_t>(v)] = true;
  }
  return used;
}

std::vector<ScreenVertex> ProjectVertices(const Scene& scene, const ViewOptions& options) {
  const double yaw = options.yaw * kRadians;
  const double pitch = options.pitch * kRadians;
  const BoundingSphere bounds = Bound(scene);
  const Projection project(options);
  const std::vector<bool> used = UsedVertices(scene);
  std::vector<ScreenVertex> screen(scene.vertices.size());
  for (size_t i = 0; i < screen.size(); ++i) {
    if (!used[i]) continue;
    const SceneVertex& v = scene.vertices[i];
    const Vec3 p = project(Rotate((1 / bounds.radius) * (v.position - bounds.center), yaw, pitch));
    // Also false for what is not a number; a pixel of room for the rounding.
    if (!(std::abs(p.x) < kGuardBand - 1 && std::abs(p.y) < kGuardBand - 1 && std::isfinite(p.z))) {
      throw std::runtime_error(
          fmt::format("{}: vertex {} falls outside the screen's guard band of +-{} pixels; look "
                      "for coordinates that are not finite",
                      scene.name, i, kGuardBand));
    }
    if (!IsFinite(v.normal) || !(Length(v.normal) > 0)) {
      throw std::runtime_error(
          fmt::format("{}: vertex {} has no normal; recompute the normals", scene.name, i));
    }
    screen[i] = {ScreenCoord::Round(p.x), ScreenCoord::Round(p.y),
                 VertexDepth::Saturate(std::llround(std::ldexp(p.z, VertexDepth::kFraction))),
                 RoundUnit(Rotate(Normalize(v.normal), yaw, pitch))};
  }
  return screen;
}

}  // namespace

TriangleList Project(const Scene& scene, const ViewOptions& options) {
  CheckOptions(options);
  if (scene.triangles.empty()) {
    throw std::runtime_error(fmt::format("{}: has no triangles; nothing to draw", scene.name));
  }
  TriangleList list;
  list.frame = MakeFrame(scene, options);
  const std::vector<ScreenVertex> vertices = ProjectVertices(scene, options);
  list.triangles.reserve(scene.triangles.size());
  for (const SceneTriangle& t : scene.triangles) {
    TrianglePacket packet;
    for (size_t k = 0; k < 3; ++k) {
      const ScreenVertex& v = vertices[static_cast<size_t>(t.vertex[k])];
      packet.x[k] = v.x;
      packet.y[k] = v.y;
      packet.z[k] = v.z;
      packet.n[k] = v.n;
    }
    packet.material = t.material;
    list.triangles.push_back(packet);
  }
  return list;
}

}  // namespace shading::sim
