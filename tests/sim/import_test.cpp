// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/import.h"

#include <fmt/format.h>

#include "sim/scene/builtin.h"
#include "sim/scene/camera.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

using ImportTest = FileTest;

const char kModels[] = "/usr/share/assimp/models/";  // Debian's assimp-testmodels

Scene MustLoad(const std::string& path) {
  const Scene scene = ImportMesh(path);
  EXPECT_FALSE(scene.triangles.empty()) << path;
  for (const SceneVertex& v : scene.vertices) {
    EXPECT_TRUE(IsFinite(v.position)) << path;
    EXPECT_NEAR(Length(v.normal), 1, 1e-12) << path;
  }
  for (const SceneTriangle& t : scene.triangles) {
    EXPECT_LT(static_cast<size_t>(t.material), scene.materials.size());
  }
  for (const SceneMaterial& m : scene.materials) {
    EXPECT_GE(m.shininess, 1) << path;
    EXPECT_LE(m.shininess, 256) << path;
  }
  EXPECT_EQ(Project(scene, {}).triangles.size(), scene.triangles.size());
  return scene;
}

TEST_F(ImportTest, ModelsOfEveryFormat) {
  if (!std::filesystem::is_directory(kModels)) {
    GTEST_SKIP() << kModels << " is absent: install assimp-testmodels to test real meshes";
  }
  for (const char* name :
       {"OBJ/box.obj", "OBJ/spider.obj", "OBJ/WusonOBJ.obj", "OBJ/regr01.obj", "OBJ/testmixed.obj",
        "PLY/cube.ply", "PLY/cube_binary.ply", "PLY/Wuson.ply", "STL/Spider_ascii.stl",
        "STL/Spider_binary.stl", "STL/Wuson.stl", "glTF/TwoBoxes/TwoBoxes.gltf",
        "glTF2/BoxTextured-glTF/BoxTextured.gltf", "glTF2/BoxTextured-glTF-Binary/BoxTextured.glb",
        "glTF2/2CylinderEngine-glTF-Binary/2CylinderEngine.glb",
        "glTF2/BoxTextured-glTF-pbrSpecularGlossiness/BoxTextured.gltf",
        "glTF2/BoxBadNormals-glTF-Binary/BoxBadNormals.glb", "OFF/Cube.off"}) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(MustLoad(std::string(kModels) + name));
  }
}

TEST_F(ImportTest, ModelsThatAreRefused) {
  if (!std::filesystem::is_directory(kModels)) {
    GTEST_SKIP() << kModels << " is absent: install assimp-testmodels to test real meshes";
  }
  for (const char* name :
       {"OBJ/testpoints.obj", "OBJ/testline.obj", "OBJ/point_cloud.obj", "PLY/points.ply",
        "invalid/empty.obj", "invalid/malformed.obj", "glTF2/MissingBin/BoxTextured.gltf",
        "glTF2/RecursiveNodes/RecursiveNodes.gltf", "glTF2/wrongTypes/badNumber.gltf",
        "glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb"}) {
    SCOPED_TRACE(name);
    ExpectError([&] { ImportMesh(std::string(kModels) + name); }, name);
  }
}

const char kFace[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(ImportTest, MtlMaterials) {
  Write("a.mtl",
        "newmtl first\nKa 0.1 0.2 0.3\nKd 0.4 0.5 1.5\nKs 0.7 0.8 0.9\nNs 60\nillum 2\n"
        "newmtl second\nKa 1 1 1\nKd 0.5 0.5 0.5\nNs 1000\n"
        "newmtl third\nKd 1 0 0\nKs 0 0 0\nNs 0\n");
  const Scene scene = MustLoad(Write("a.obj", std::string("mtllib a.mtl\n") + kFace +
                                                  "usemtl first\nf 1 2 3\nusemtl second\nf 1 2 3\n"
                                                  "usemtl third\nf 1 2 3\n"));
  ASSERT_EQ(scene.triangles.size(), 3u);
  const auto material = [&](size_t i) {
    return scene.materials[static_cast<size_t>(scene.triangles[i].material)];
  };
  const SceneMaterial first = material(0);
  EXPECT_NEAR(first.ambient[2], 0.3, 1e-6);
  EXPECT_NEAR(first.diffuse[0], 0.4, 1e-6);
  EXPECT_EQ(first.diffuse[2], 1);
  EXPECT_NEAR(first.specular[1], 0.8, 1e-6);
  EXPECT_NEAR(first.shininess, 60, 1e-6);
  EXPECT_NEAR(material(1).ambient[0], 0.05, 1e-6);  // Ka 1 1 1 of an exporter
  EXPECT_EQ(material(1).specular[0], 0);
  EXPECT_EQ(material(1).shininess, 256);
  EXPECT_EQ(material(2).diffuse[0], 1);
  EXPECT_EQ(material(2).shininess, 1);
}

TEST_F(ImportTest, DefaultMaterialWithoutAny) {
  const Scene scene = MustLoad(Write("a.obj", std::string(kFace) + "f 1 2 3\n"));
  const SceneMaterial m = scene.materials[static_cast<size_t>(scene.triangles[0].material)];
  EXPECT_EQ(m.diffuse, SceneMaterial().diffuse);
  EXPECT_EQ(m.specular, SceneMaterial().specular);
  EXPECT_EQ(m.shininess, SceneMaterial().shininess);
}

// Creases of 90 degrees stay sharp, with the file's faces split at them.
TEST_F(ImportTest, NormalsAreMadeWhereAbsent) {
  const Scene scene =
      MustLoad(Write("a.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3 4\nf 1 5 2\n"));
  EXPECT_EQ(scene.triangles.size(), 3u);
  EXPECT_EQ(scene.vertices.size(), 7u);
  for (const SceneVertex& v : scene.vertices) {
    EXPECT_NEAR(std::max(std::abs(v.normal.y), std::abs(v.normal.z)), 1, 1e-6);
  }
}

// A tetrahedron strip bent by 20 degrees is smoothed although STL stores facet normals.
TEST_F(ImportTest, StlIsSmoothed) {
  const std::string stl =
      "solid a\n"
      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n"
      "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 -0.4\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n";
  const Scene scene = MustLoad(Write("a.stl", stl));
  EXPECT_EQ(scene.vertices.size(), 4u);
  for (const SceneVertex& v : scene.vertices) {
    if (v.position.x == 1 && v.position.y == 0) {
      EXPECT_GT(v.normal.x, 0.1);
    }
  }
}

TEST_F(ImportTest, ZeroNormalsAreRecomputed) {
  const Scene scene = MustLoad(Write("a.obj", std::string(kFace) + "vn 0 0 0\nf 1//1 2//1 3//1\n"));
  for (const SceneVertex& v : scene.vertices) EXPECT_EQ(v.normal.z, 1);
  // Two faces back to back have no mean.
  ExpectError(
      [&] {
        ImportMesh(
            Write("b.obj", std::string(kFace) + "vn 0 0 0\nf 1//1 2//1 3//1\nf 3//1 2//1 1//1\n"));
      },
      "b.obj: vertex 0 has no normal and its faces cancel");
}

TEST_F(ImportTest, DegenerateTrianglesAreKept) {
  const Scene scene = MustLoad(
      Write("a.obj", std::string(kFace) + "vn 0 0 0\nf 1//1 2//1 3//1\nf 1//1 1//1 2//1\n"));
  EXPECT_EQ(scene.triangles.size(), 2u);
}

std::string Ply(const std::string& vertices, const std::string& extra) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
         "property float z\n" +
         extra + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + vertices +
         "3 0 1 2\n";
}
const char kPlyNormals[] = "property float nx\nproperty float ny\nproperty float nz\n";

TEST_F(ImportTest, NotFinite) {
  ExpectError([&] { ImportMesh(Write("a.ply", Ply("0 0 0\nnan 0 0\n0 1 0\n", ""))); },
              "a.ply: position of vertex");
  ExpectError([&] { ImportMesh(Write("b.ply", Ply("0 0 0\n1 0 0\n0 inf 0\n", ""))); },
              "b.ply: position of vertex");
  ExpectError(
      [&] {
        ImportMesh(Write("c.ply", Ply("0 0 0 0 0 1\n1 0 0 0 nan 1\n0 1 0 0 0 1\n", kPlyNormals)));
      },
      "c.ply: normal of vertex");
  Write("d.mtl", "newmtl bad\nKd nan 0 0\n");
  ExpectError(
      [&] {
        ImportMesh(Write("d.obj", std::string("mtllib d.mtl\n") + kFace + "usemtl bad\nf 1 2 3\n"));
      },
      "d.obj: material 'bad' has a diffuse that is not a finite number");
}

TEST_F(ImportTest, BadFiles) {
  ExpectError([&] { ImportMesh(Path("none.obj")); }, "none.obj: no such file; check the path");
  ExpectError([&] { ImportMesh(Path("")); }, "is a folder; give a mesh file");
  ExpectError([&] { ImportMesh(Write("a.txt", "text")); }, "a.txt: not a mesh format");
  ExpectError([&] { ImportMesh(Write("a", "text")); }, "not a mesh format");
  ExpectError([&] { ImportMesh(Write("a.stl", "not a mesh at all")); }, "export the mesh again");
  ExpectError([&] { ImportMesh(Write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\np 1\n")); }, "a.obj: ");
  ExpectError([&] { ImportMesh(Write("a.gltf", "{\n\"asset\":\n")); }, "a.gltf: cannot be read");
}

// One triangle with normals, under a node with the given scale, of the given material.
std::string Gltf(const std::string& scale, const std::string& material) {
  const char* data =
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"   // (0 0 0) (1 0 0) (0 1 0)
      "AAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/AAAAAAAAAAAAAIA/";  // three times (0 0 1)
  return fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],)"
      R"("nodes":[{{"mesh":0,"scale":{},"translation":[5,0,0]}}],)"
      R"("materials":[{}],"meshes":[{{"primitives":[{{"material":0,)"
      R"("attributes":{{"POSITION":0,"NORMAL":1}}}}]}}],)"
      R"("buffers":[{{"byteLength":72,"uri":"data:application/octet-stream;base64,{}"}}],)"
      R"("bufferViews":[{{"buffer":0,"byteLength":36}},)"
      R"({{"buffer":0,"byteOffset":36,"byteLength":36}}],)"
      R"("accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
      R"("min":[0,0,0],"max":[1,1,0]}},)"
      R"({{"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"}}]}})",
      scale, material, data);
}

TEST_F(ImportTest, MirroredNodeKeepsTheOutside) {
  const std::pair<const char*, double> nodes[] = {
      {"[1,1,1]", 1}, {"[-1,1,1]", 1}, {"[-2,3,-1]", -1}, {"[1,2,-1]", -1}};
  for (const auto& [scale, outside] : nodes) {
    const Scene scene = MustLoad(Write("a.gltf", Gltf(scale, "{}")));
    ASSERT_EQ(scene.triangles.size(), 1u);
    std::array<Vec3, 3> p;
    for (size_t k = 0; k < 3; ++k) {
      p[k] = scene.vertices[static_cast<size_t>(scene.triangles[0].vertex[k])].position;
    }
    const Vec3 area = Cross(p[1] - p[0], p[2] - p[0]);
    EXPECT_NEAR(Dot(Normalize(area), scene.vertices[0].normal), 1, 1e-6) << scale;
    EXPECT_NEAR(scene.vertices[0].normal.z, outside, 1e-6) << scale;
    EXPECT_NEAR(std::max({p[0].x, p[1].x, p[2].x}), scale[1] == '-' ? 5 : 6, 1e-6) << scale;
  }
}

SceneMaterial GltfMaterial(const Scene& scene) {
  return scene.materials[static_cast<size_t>(scene.triangles[0].material)];
}

TEST_F(ImportTest, MetallicRoughness) {
  const auto load = [&](double metallic, double roughness) {
    const std::string material =
        fmt::format(R"({{"pbrMetallicRoughness":{{"baseColorFactor":[0.8,0.4,0.2,1],)"
                    R"("metallicFactor":{},"roughnessFactor":{}}}}})",
                    metallic, roughness);
    return GltfMaterial(MustLoad(Write("a.gltf", Gltf("[1,1,1]", material))));
  };
  const SceneMaterial plastic = load(0, 0.5);
  EXPECT_NEAR(plastic.diffuse[0], 0.8, 1e-6);
  EXPECT_NEAR(plastic.ambient[1], 0.04, 1e-6);
  EXPECT_NEAR(plastic.specular[0], 0.02, 1e-6);
  EXPECT_NEAR(plastic.shininess, 30, 1e-4);  // 2 / 0.5^4 - 2
  const SceneMaterial metal = load(1, 0.25);
  EXPECT_NEAR(metal.specular[0], 0.6, 1e-6);
  EXPECT_NEAR(metal.specular[2], 0.15, 1e-6);
  EXPECT_EQ(metal.shininess, 256);
  EXPECT_EQ(load(1, 0).shininess, 256);
  EXPECT_EQ(load(1, 1).shininess, 1);
  EXPECT_EQ(load(1, 1).specular[0], 0);
}

}  // namespace
}  // namespace shading::sim
