// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/import.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <filesystem>
#include <stdexcept>

#include "sim/scene/import_material.h"

namespace shading::sim {
namespace {

constexpr float kCreaseDegrees = 60;

std::string LowerExtension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

// The scene stays the importer's.
const aiScene& ReadFile(const std::string& path, Assimp::Importer* importer) {
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(fmt::format("{}: is a folder; give a mesh file", path));
  }
  if (!std::filesystem::is_regular_file(path)) {
    throw std::runtime_error(fmt::format("{}: no such file; check the path", path));
  }
  const std::string extension = LowerExtension(path);
  if (!importer->IsExtensionSupported(extension)) {
    throw std::runtime_error(fmt::format(
        "{}: not a mesh format that assimp reads; convert it to .obj, .ply, .stl or .gltf", path));
  }
  importer->SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                               aiPrimitiveType_POINT | aiPrimitiveType_LINE);
  importer->SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kCreaseDegrees);
  unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GenSmoothNormals |
                   aiProcess_JoinIdenticalVertices;
  if (extension == ".stl") {
    steps |= aiProcess_RemoveComponent;
    importer->SetPropertyInteger(AI_CONFIG_PP_RVC_FLAGS, aiComponent_NORMALS);
  }
  const aiScene* scene = importer->ReadFile(path, steps);
  if (scene == nullptr) {
    std::string reason = importer->GetErrorString();
    std::replace(reason.begin(), reason.end(), '\n', ' ');
    throw std::runtime_error(
        fmt::format("{}: cannot be read ({}); export the mesh again", path, reason));
  }
  return *scene;
}

Vec3 ToVec3(const aiVector3D& v) { return {v.x, v.y, v.z}; }

class SceneBuilder {
 public:
  SceneBuilder(const std::string& path, const aiScene& source) : source_(source) {
    scene_.name = path;
  }

  Scene Build() {
    for (unsigned i = 0; i < source_.mNumMaterials; ++i) AddMaterial(*source_.mMaterials[i]);
    if (scene_.materials.empty()) scene_.materials.emplace_back();
    if (source_.mRootNode != nullptr) AddNode(*source_.mRootNode, aiMatrix4x4());
    if (scene_.triangles.empty()) Fail("holds no triangles; export surfaces, not points or lines");
    CheckFinite();
    RepairNormals();
    return std::move(scene_);
  }

 private:
  [[noreturn]] void Fail(const std::string& what) const {
    throw std::runtime_error(fmt::format("{}: {}", scene_.name, what));
  }

  void AddMaterial(const aiMaterial& material) {
    try {
      scene_.materials.push_back(ConvertMaterial(material));
    } catch (const std::runtime_error& error) {
      Fail(fmt::format("{}; correct the material", error.what()));
    }
  }

  void AddNode(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 to_world = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      AddMesh(*source_.mMeshes[node.mMeshes[i]], to_world);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) AddNode(*node.mChildren[i], to_world);
  }

  void AddMesh(const aiMesh& mesh, const aiMatrix4x4& to_world) {
    if (!mesh.HasNormals()) Fail("a mesh has no normals; export them");
    const int first = static_cast<int>(scene_.vertices.size());
    const aiMatrix3x3 linear(to_world);
    // Normals go with the cofactors of the linear part, its inverse transpose times the
    // determinant; the sign of the determinant turns the faces instead.
    const Vec3 column[3] = {{linear.a1, linear.b1, linear.c1},
                            {linear.a2, linear.b2, linear.c2},
                            {linear.a3, linear.b3, linear.c3}};
    const Vec3 cofactor[3] = {Cross(column[1], column[2]), Cross(column[2], column[0]),
                              Cross(column[0], column[1])};
    const double determinant = Dot(column[0], cofactor[0]);
    const double sign = determinant < 0 ? -1 : 1;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const Vec3 n = ToVec3(mesh.mNormals[i]);
      scene_.vertices.push_back(
          {ToVec3(to_world * mesh.mVertices[i]),
           sign * (n.x * cofactor[0] + n.y * cofactor[1] + n.z * cofactor[2])});
    }
    const int material = std::clamp(static_cast<int>(mesh.mMaterialIndex), 0,
                                    static_cast<int>(scene_.materials.size()) - 1);
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices != 3) continue;
      SceneTriangle t;
      for (unsigned k = 0; k < 3; ++k) {
        t.vertex[sign < 0 ? 2 - k : k] = first + static_cast<int>(face.mIndices[k]);
      }
      t.material = material;
      scene_.triangles.push_back(t);
    }
  }

  void CheckFinite() const {
    for (size_t i = 0; i < scene_.vertices.size(); ++i) {
      if (!IsFinite(scene_.vertices[i].position)) {
        Fail(fmt::format("position of vertex {} is not finite; repair the mesh", i));
      }
      if (!IsFinite(scene_.vertices[i].normal)) {
        Fail(fmt::format("normal of vertex {} is not finite; recompute the normals", i));
      }
    }
  }

  // Twice the area times the face's normal.
  Vec3 AreaVector(const SceneTriangle& t) const {
    const Vec3 origin = Position(t, 0);
    return Cross(Position(t, 1) - origin, Position(t, 2) - origin);
  }
  Vec3 Position(const SceneTriangle& t, size_t k) const {
    return scene_.vertices[static_cast<size_t>(t.vertex[k])].position;
  }

  // Makes every normal a unit vector. Only a vertex whose faces cancel each other has none; one
  // without any face of an area is never shaded, and any direction will do.
  void RepairNormals() {
    std::vector<Vec3> sum(scene_.vertices.size());
    std::vector<bool> in_use(scene_.vertices.size());
    for (const SceneTriangle& t : scene_.triangles) {
      const Vec3 area = AreaVector(t);
      if (!(Length(area) > 0)) continue;
      for (const int v : t.vertex) {
        sum[static_cast<size_t>(v)] = sum[static_cast<size_t>(v)] + area;
        in_use[static_cast<size_t>(v)] = true;
      }
    }
    for (size_t i = 0; i < scene_.vertices.size(); ++i) {
      Vec3 normal = scene_.vertices[i].normal;
      if (!(Length(normal) > 0)) normal = sum[i];
      if (!(Length(normal) > 0)) {
        if (in_use[i]) {
          Fail(fmt::format("vertex {} has no normal and its faces cancel; recompute the normals",
                           i));
        }
        normal = {0, 0, 1};
      }
      scene_.vertices[i].normal = Normalize(normal);
    }
  }

  const aiScene& source_;
  Scene scene_;
};

}  // namespace

Scene ImportMesh(const std::string& path) {
  Assimp::Importer importer;
  const aiScene& source = ReadFile(path, &importer);
  return SceneBuilder(path, source).Build();
}

}  // namespace shading::sim
