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

// About the centre of the bounding box: at most sqrt(3) times the smallest sphere, and as small as
// possible for anything that reaches as far on both sides of its centre.
BoundingSphere Bound(const std::vector<SceneVertex>& vertices) {
  Vec3 low = vertices.front().position;
  Vec3 high = low;
  for (const SceneVertex& v : vertices) {
    low = {std::min(low.x, v.position.x), std::min(low.y, v.position.y),
           std::min(low.z, v.position.z)};
    high = {std::max(high.x, v.position.x), std::max(high.y, v.position.y),
            std::max(high.z, v.position.z)};
  }
  BoundingSphere sphere{0.5 * low + 0.5 * high, 0};
  for (const SceneVertex& v : vertices) {
    sphere.radius = std::max(sphere.radius, Length(v.position - sphere.center));
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
  if (!IsFinite(options.light) || !(Length(options.light) > 0)) {
    throw std::runtime_error(
        fmt::format("light {},{},{}: has no direction; give a vector of "
                    "finite numbers that are not all zero",
                    options.light.x, options.light.y, options.light.z));
  }
}

FrameState MakeFrame(const Scene& scene, const ViewOptions& options) {
  const Vec3 view = {0, 0, 1};
  const double largest =
      std::max({std::abs(options.light.x), std::abs(options.light.y), std::abs(options.light.z)});
  const Vec3 light = Normalize((1 / largest) * options.light);
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

std::vector<ScreenVertex> ProjectVertices(const Scene& scene, const ViewOptions& options) {
  const double yaw = options.yaw * kRadians;
  const double pitch = options.pitch * kRadians;
  const BoundingSphere bounds = Bound(scene.vertices);
  const Projection project(options);
  std::vector<ScreenVertex> screen;
  screen.reserve(scene.vertices.size());
  for (const SceneVertex& v : scene.vertices) {
    const Vec3 p = project(Rotate((1 / bounds.radius) * (v.position - bounds.center), yaw, pitch));
    // Also false for what is not a number; a pixel of room for the rounding.
    if (!(std::abs(p.x) < kGuardBand - 1 && std::abs(p.y) < kGuardBand - 1 && std::isfinite(p.z))) {
      throw std::runtime_error(fmt::format(
          "{}: vertex {} falls outside the screen's guard band of +-{} pixels; look for "
          "coordinates that are not finite",
          scene.name, screen.size(), kGuardBand));
    }
    const double length = Length(v.normal);
    if (!std::isfinite(length) || !(length > 0)) {
      throw std::runtime_error(fmt::format("{}: vertex {} has no normal; recompute the normals",
                                           scene.name, screen.size()));
    }
    screen.push_back({ScreenCoord::Round(p.x), ScreenCoord::Round(p.y),
                      VertexDepth::Saturate(std::llround(std::ldexp(p.z, VertexDepth::kFraction))),
                      RoundUnit(Rotate((1 / length) * v.normal, yaw, pitch))});
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
