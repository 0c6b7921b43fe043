// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/builtin.h"

#include <set>

#include "sim/scene/shapes.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

const SceneVertex& Corner(const Scene& scene, const SceneTriangle& t, size_t k) {
  return scene.vertices.at(static_cast<size_t>(t.vertex[k]));
}

// Directed edges that have no partner in the other direction: 0 for a closed surface.
size_t OpenEdges(const Scene& scene) {
  std::set<std::pair<int, int>> edges;
  for (const SceneTriangle& t : scene.triangles) {
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_TRUE(edges.insert({t.vertex[k], t.vertex[(k + 1) % 3]}).second) << "edge used twice";
    }
  }
  size_t open = 0;
  for (const auto& [a, b] : edges) open += edges.count({b, a}) == 0 ? 1 : 0;
  return open;
}

TEST(BuiltinTest, FrontFacesAgreeWithNormals) {
  for (const BuiltinScene& entry : kBuiltinScenes) {
    for (const int n : {entry.min_n, entry.default_n, 33}) {
      const Scene scene = MakeBuiltin(std::string(entry.name) + ":" + std::to_string(n));
      ASSERT_FALSE(scene.triangles.empty()) << scene.name;
      for (const SceneVertex& v : scene.vertices) ASSERT_NEAR(Length(v.normal), 1, 1e-12);
      for (const SceneTriangle& t : scene.triangles) {
        ASSERT_LT(static_cast<size_t>(t.material), scene.materials.size());
        const Vec3 a = Corner(scene, t, 0).position;
        const Vec3 area = Cross(Corner(scene, t, 1).position - a, Corner(scene, t, 2).position - a);
        ASSERT_GT(Length(area), 0) << scene.name;
        Vec3 mean;
        for (size_t k = 0; k < 3; ++k) mean = mean + Corner(scene, t, k).normal;
        ASSERT_GT(Dot(area, mean), 0) << scene.name;
      }
    }
  }
}

TEST(BuiltinTest, NormalsAreExact) {
  for (const SceneVertex& v : Sphere(9).vertices) {
    EXPECT_NEAR(Length(v.normal - v.position), 0, 1e-14);
  }
  for (const SceneVertex& v : Torus(9).vertices) {
    const Vec3 ring = Normalize({v.position.x, v.position.y, 0});
    EXPECT_NEAR(Length(v.position - ring - 0.4 * v.normal), 0, 1e-14);
  }
  for (const SceneVertex& v : Cylinder(9).vertices) {
    EXPECT_NEAR(Length(v.position - Vec3{0, v.position.y, 0} - 0.25 * v.normal), 0, 1e-14);
  }
  for (const SceneVertex& v : Saddle(9).vertices) {
    const Vec3 p = v.position;
    EXPECT_NEAR(p.z, p.x * p.y / 2, 1e-15);
    EXPECT_NEAR(Dot(v.normal, {1, 0, p.y / 2}), 0, 1e-15);  // both tangents
    EXPECT_NEAR(Dot(v.normal, {0, 1, p.x / 2}), 0, 1e-15);
  }
}

TEST(BuiltinTest, CountsAndClosedSurfaces) {
  EXPECT_EQ(Sphere(8).triangles.size(), 2u * 16 * 7);
  EXPECT_EQ(OpenEdges(Sphere(8)), 0u);
  EXPECT_EQ(OpenEdges(Sphere(2)), 0u);
  EXPECT_EQ(Torus(8).triangles.size(), 128u);
  EXPECT_EQ(OpenEdges(Torus(8)), 0u);
  EXPECT_EQ(Saddle(8).triangles.size(), 128u);
  EXPECT_EQ(OpenEdges(Saddle(8)), 32u);
  EXPECT_EQ(Triangle(5).triangles.size(), 25u);
  EXPECT_EQ(OpenEdges(Panel(8)), 32u);
  EXPECT_EQ(OpenEdges(Cylinder(8)), 16u);
  EXPECT_EQ(OpenEdges(Triangle(5)), 15u);
}

// Subdividing the triangle keeps its corners.
TEST(BuiltinTest, TriangleKeepsItsCorners) {
  const Scene one = Triangle(1);
  const Scene many = Triangle(4);
  EXPECT_NEAR(Length(one.vertices[0].position - many.vertices[0].position), 0, 1e-15);
  EXPECT_NEAR(Length(one.vertices[1].normal - many.vertices[10].normal), 0, 1e-15);
  EXPECT_NEAR(Length(one.vertices[2].position - many.vertices[14].position), 0, 1e-15);
}

TEST(BuiltinTest, TriangleHasAHighlightInside) {
  const Vec3 half = Normalize(Normalize({0.4, 0.5, 0.8}) + Vec3{0, 0, 1});
  double corners = 0;
  for (const SceneVertex& v : Triangle(1).vertices)
    corners = std::max(corners, Dot(v.normal, half));
  double inside = 0;
  for (const SceneVertex& v : Triangle(50).vertices) inside = std::max(inside, Dot(v.normal, half));
  EXPECT_LT(corners, 0.92);
  EXPECT_GT(inside, 0.999);
}

TEST(BuiltinTest, MixedHasSeveralMaterials) {
  const Scene scene = MakeBuiltin("mixed");
  std::set<int> used;
  for (const SceneTriangle& t : scene.triangles) used.insert(t.material);
  EXPECT_GE(used.size(), 4u);
  EXPECT_EQ(used.size(), scene.materials.size());
}

TEST(BuiltinTest, SpellingsOfAName) {
  EXPECT_EQ(MakeBuiltin("sphere").name, "builtin:sphere:16");
  EXPECT_EQ(MakeBuiltin("builtin:sphere:7").name, "builtin:sphere:7");
  EXPECT_EQ(MakeBuiltin("saddle:1").triangles.size(), 2u);
}

TEST(BuiltinTest, BadNames) {
  ExpectError(
      [] { MakeBuiltin("cube"); },
      "builtin:cube: no such scene; use one of: triangle sphere torus saddle panel cylinder mixed");
  ExpectError([] { MakeBuiltin("builtin:"); }, "no such scene");
  for (const char* spec : {"sphere:0", "sphere:1", "sphere:2049", "sphere:", "sphere:-3",
                           "sphere:4x", "sphere:4:4", "sphere:99999999999999"}) {
    ExpectError([&] { MakeBuiltin(spec); }, "must be a whole number from 2 to 2048");
  }
}

}  // namespace
}  // namespace shading::sim
