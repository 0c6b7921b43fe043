// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/camera.h"

#include <limits>

#include "sim/scene/builtin.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Twice the signed area, y down, in raw units: negative for a front face.
int64_t SignedArea(const TrianglePacket& t) {
  return (t.x[1].raw() - t.x[0].raw()) * (t.y[2].raw() - t.y[0].raw()) -
         (t.x[2].raw() - t.x[0].raw()) * (t.y[1].raw() - t.y[0].raw());
}

double SquaredLength(const Vector3& v) {
  double sum = 0;
  for (const NormalComponent c : v) sum += c.ToReal() * c.ToReal();
  return sum;
}

struct Box {
  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9, near = 1e9, far = -1e9;
};

Box Bounds(const TriangleList& list) {
  Box b;
  for (const TrianglePacket& t : list.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      b.left = std::min(b.left, t.x[k].ToReal());
      b.right = std::max(b.right, t.x[k].ToReal());
      b.top = std::min(b.top, t.y[k].ToReal());
      b.bottom = std::max(b.bottom, t.y[k].ToReal());
      b.near = std::min(b.near, t.z[k].ToReal());
      b.far = std::max(b.far, t.z[k].ToReal());
    }
  }
  return b;
}

class CameraTest : public ::testing::TestWithParam<bool> {
 protected:
  ViewOptions Options() const {
    ViewOptions options;
    options.perspective = GetParam();
    return options;
  }
};
INSTANTIATE_TEST_SUITE_P(Projection, CameraTest, ::testing::Values(false, true),
                         [](const auto& projection) {
                           return projection.param ? "persp" : "ortho";
                         });

TEST_P(CameraTest, SphereFillsTheShorterSide) {
  for (const auto& [width, height] : {std::pair(640, 480), std::pair(300, 4000), std::pair(64, 64),
                                      std::pair(4096, 4096), std::pair(4096, 1)}) {
    ViewOptions options = Options();
    options.width = width;
    options.height = height;
    const Box b = Bounds(Project(MakeBuiltin("sphere:64"), options));
    const double side = std::min(width, height);
    EXPECT_NEAR((b.left + b.right) / 2, width / 2.0, 0.01);
    EXPECT_NEAR((b.top + b.bottom) / 2, height / 2.0, 0.01);
    EXPECT_NEAR(b.right - b.left, 0.95 * side, 0.002 * side + 0.01);
    EXPECT_NEAR(b.bottom - b.top, 0.95 * side, 0.002 * side + 0.01);
    EXPECT_GE(b.near, 0);
    EXPECT_LT(b.near, 1e-3);
    EXPECT_LT(b.far, 1);
    EXPECT_GT(b.far, 0.99);
  }
}

TEST_P(CameraTest, EverySceneAndAngleStaysInside) {
  for (const BuiltinScene& entry : kBuiltinScenes) {
    const Scene scene = MakeBuiltin(entry.name);
    for (const double angle : {-170.0, -35.0, 0.0, 80.0, 725.0}) {
      ViewOptions options = Options();
      options.yaw = angle;
      options.pitch = 0.7 * angle;
      const TriangleList list = Project(scene, options);
      ASSERT_EQ(list.triangles.size(), scene.triangles.size());
      const Box b = Bounds(list);
      EXPECT_GT(std::min(b.left, b.top), 0) << entry.name;
      EXPECT_LT(b.right, options.width) << entry.name;
      EXPECT_LT(b.bottom, options.height) << entry.name;
    }
  }
}

TEST_P(CameraTest, HalfOfASphereIsInFront) {
  for (const double yaw : {0.0, 63.0}) {
    ViewOptions options = Options();
    options.yaw = yaw;
    options.pitch = 20;
    const TriangleList list = Project(MakeBuiltin("sphere:32"), options);
    // The cone of perspective touches nearer to the viewer than the outline; see camera.h.
    const double lowest = options.perspective ? 0.2 : -0.1;
    double front = 0;
    for (const TrianglePacket& t : list.triangles) {
      if (SignedArea(t) >= 0) continue;
      front += 1;
      for (const Vector3& n : t.n) ASSERT_GT(n[2].ToReal(), lowest);
    }
    const double share = front / static_cast<double>(list.triangles.size());
    EXPECT_GT(share, options.perspective ? 0.25 : 0.48);
    EXPECT_LT(share, 0.52);
  }
}

TEST_P(CameraTest, NormalsAreUnit) {
  const TriangleList list = Project(MakeBuiltin("torus"), Options());
  for (const TrianglePacket& t : list.triangles) {
    for (const Vector3& n : t.n) ASSERT_NEAR(SquaredLength(n), 1, std::ldexp(1, -20));
  }
  for (const Vector3& v : {list.frame.light, list.frame.half, list.frame.view}) {
    EXPECT_NEAR(SquaredLength(v), 1, std::ldexp(1, -20));
  }
}

// x right, y up on the screen (so smaller y), near is smaller z.
TEST_P(CameraTest, Orientation) {
  Scene scene;
  scene.name = "axes";
  scene.materials.emplace_back();
  const Vec3 n = {0, 0, 1};
  scene.vertices = {{{1, 0, 0}, n}, {{0, 1, 0}, n}, {{0, 0, 1}, n}, {{-1, -1, -1}, n}};
  scene.triangles = {{{0, 1, 2}, 0}, {{3, 3, 3}, 0}};
  ViewOptions options = Options();
  const TriangleList list = Project(scene, options);
  const TrianglePacket& t = list.triangles[0];
  EXPECT_GT(t.x[0].raw(), t.x[1].raw());
  EXPECT_LT(t.y[1].raw(), t.y[0].raw());
  EXPECT_LT(t.z[2].raw(), t.z[0].raw());
  EXPECT_LT(SignedArea(t), 0);
  // A quarter turn about y brings z to the right; about x, it brings z down.
  options.yaw = 90;
  EXPECT_GT(Project(scene, options).triangles[0].x[2].ToReal(), options.width / 2.0 + 20);
  options.yaw = 0;
  options.pitch = 90;
  EXPECT_GT(Project(scene, options).triangles[0].y[2].ToReal(), options.height / 2.0 + 20);
}

// Depth is affine on the screen: the middle of an edge on the screen has the mean depth.
TEST(CameraDepthTest, PerspectiveDepthIsAffineOnTheScreen) {
  Scene scene;
  scene.materials.emplace_back();
  const Vec3 n = {0, 0, 1};
  // Viewer at distance d: the point on a-b whose projection is the middle one solves 1/w.
  const double half_side = 0.95 * std::tan(22.5 * 3.14159265358979323846 / 180);
  const double d = std::sqrt(1 + 1 / (half_side * half_side));
  const double wa = d + 0.6;
  const double wb = d - 0.6;
  const double wm = 2 / (1 / wa + 1 / wb);
  const double s = (wm - wa) / (wb - wa);
  const Vec3 a = {-0.8, 0, -0.6};
  const Vec3 b = {0.8, 0, 0.6};
  scene.vertices = {{a, n}, {b, n}, {a + s * (b - a), n}};
  scene.triangles = {{{0, 1, 2}, 0}};
  ViewOptions options;
  options.perspective = true;
  const TrianglePacket t = Project(scene, options).triangles[0];
  EXPECT_NEAR(t.x[2].ToReal(), (t.x[0].ToReal() + t.x[1].ToReal()) / 2, 0.01);
  EXPECT_NEAR(t.z[2].ToReal(), (t.z[0].ToReal() + t.z[1].ToReal()) / 2, 1e-6);
  // And tells the distance up to a factor.
  const double slope = Project(scene, options).frame.depth_slope.ToReal();
  EXPECT_NEAR((1 - slope * t.z[0].ToReal()) / (1 - slope * t.z[1].ToReal()), wb / wa, 1e-6);
  EXPECT_EQ(Project(scene, ViewOptions()).frame.depth_slope.raw(), 0);
}

TEST(CameraFrameTest, LightHalfAndMaterials) {
  ViewOptions options;
  options.light = {0, 3e-320, 3e-320};
  options.lighting = Lighting::kPhong;
  options.cull = Cull::kNone;
  Scene scene = MakeBuiltin("triangle");
  scene.materials[0] = {{0, 0.5, 2}, {1, 1, 1}, {-1, 0, 0}, 1000};
  const FrameState frame = Project(scene, options).frame;
  EXPECT_NEAR(frame.light[1].ToReal(), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(frame.light[2].ToReal(), std::sqrt(0.5), 1e-3);
  EXPECT_NEAR(frame.half[2].ToReal(), std::cos(3.14159265358979323846 / 8), 1e-3);
  EXPECT_EQ(frame.view[2].ToReal(), 1);
  EXPECT_EQ(frame.lighting, Lighting::kPhong);
  EXPECT_EQ(frame.cull, Cull::kNone);
  EXPECT_EQ(frame.materials[0].ambient[1].ToReal(), 0.5);
  EXPECT_EQ(frame.materials[0].ambient[2].ToReal(), 1);
  EXPECT_EQ(frame.materials[0].specular[0].ToReal(), 0);
  EXPECT_EQ(frame.materials[0].shininess.ToReal(), 256);
}

void ExpectBadOptions(void (*change)(ViewOptions*), const std::string& text) {
  ViewOptions options;
  change(&options);
  ExpectError([&] { Project(MakeBuiltin("triangle"), options); }, text);
}

TEST(CameraErrorTest, Options) {
  ExpectBadOptions([](ViewOptions* o) { o->width = 0; }, "size 0x480: width and height must be");
  ExpectBadOptions([](ViewOptions* o) { o->height = 4097; }, "1 to 4096");
  ExpectBadOptions([](ViewOptions* o) { o->yaw = kNan; }, "yaw and pitch");
  ExpectBadOptions([](ViewOptions* o) { o->pitch = HUGE_VAL; }, "yaw and pitch");
  ExpectBadOptions([](ViewOptions* o) { o->light = {0, 0, 0}; }, "has no direction");
  ExpectBadOptions([](ViewOptions* o) { o->light = {0, kNan, 1}; }, "has no direction");
  ExpectBadOptions([](ViewOptions* o) { o->light = {HUGE_VAL, 0, 1}; }, "has no direction");
  ExpectBadOptions([](ViewOptions* o) { o->light = {0, 0, -2}; }, "no half vector; tilt it");
}

TEST(CameraErrorTest, Scenes) {
  Scene scene = MakeBuiltin("triangle");
  scene.vertices[1].position.x = kNan;
  ExpectError([&] { Project(scene, {}); }, "builtin:triangle:1: vertex 1 falls outside");
  scene = MakeBuiltin("triangle");
  scene.vertices[2].normal = {0, 0, 0};
  ExpectError([&] { Project(scene, {}); }, "vertex 2 has no normal; recompute");
  ExpectError([&] { Project(Scene{"empty", {}, {}, {}}, {}); }, "empty: has no triangles");
}

TEST(CameraErrorTest, StrayVerticesDoNotCount) {
  Scene scene = MakeBuiltin("sphere");
  const Box before = Bounds(Project(scene, {}));
  scene.vertices.push_back({{1e9, kNan, 0}, {0, 0, 0}});
  EXPECT_EQ(Bounds(Project(scene, {})).right, before.right);
}

// All vertices in one point: no area, but no failure either; the unit skips and counts it.
TEST(CameraErrorTest, PointSceneIsKept) {
  Scene scene = MakeBuiltin("triangle");
  for (SceneVertex& v : scene.vertices) v.position = {5, 5, 5};
  const TriangleList list = Project(scene, {});
  EXPECT_EQ(list.triangles[0].x[0].ToReal(), 320);
  EXPECT_EQ(SignedArea(list.triangles[0]), 0);
}

}  // namespace
}  // namespace shading::sim
