// SPDX-License-Identifier: Apache-2.0
#include "sim/scene/import_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace shading::sim {
namespace {

constexpr Color kBlack = {0, 0, 0};
constexpr Color kGrey = {0.6, 0.6, 0.6};
constexpr double kAmbientShare = 0.1;         // ambient light relative to the directional light
constexpr double kDielectricSpecular = 0.04;  // reflectance of glass and plastic head on

struct Key {
  const char* name;
  unsigned type, index;
};
constexpr Key kAmbient = {AI_MATKEY_COLOR_AMBIENT};
constexpr Key kDiffuse = {AI_MATKEY_COLOR_DIFFUSE};
constexpr Key kSpecular = {AI_MATKEY_COLOR_SPECULAR};
constexpr Key kShininess = {AI_MATKEY_SHININESS};
constexpr Key kBaseColor = {AI_MATKEY_BASE_COLOR};
constexpr Key kMetallic = {AI_MATKEY_METALLIC_FACTOR};
constexpr Key kRoughness = {AI_MATKEY_ROUGHNESS_FACTOR};
constexpr Key kGlossiness = {AI_MATKEY_GLOSSINESS_FACTOR};

void CheckFinite(double value, const aiMaterial& source, const Key& key) {
  if (std::isfinite(value)) return;
  aiString name;
  source.Get(AI_MATKEY_NAME, name);
  throw std::runtime_error(fmt::format("material '{}' has a {} that is not a finite number",
                                       name.C_Str(), std::string(key.name).substr(5)));
}

std::optional<double> GetNumber(const aiMaterial& source, const Key& key) {
  ai_real value = 0;
  if (source.Get(key.name, key.type, key.index, value) != AI_SUCCESS) return {};
  CheckFinite(value, source, key);
  return value;
}

std::optional<Color> GetColor(const aiMaterial& source, const Key& key) {
  aiColor3D c;
  if (source.Get(key.name, key.type, key.index, c) != AI_SUCCESS) return {};
  for (const double channel : {c.r, c.g, c.b}) CheckFinite(channel, source, key);
  return Color{std::clamp<double>(c.r, 0, 1), std::clamp<double>(c.g, 0, 1),
               std::clamp<double>(c.b, 0, 1)};
}

Color Scale(double factor, const Color& c) { return {factor * c[0], factor * c[1], factor * c[2]}; }

// Made up by a loader: no name or the reserved one, and no shininess.
bool IsPlaceholder(const aiMaterial& source) {
  aiString name;
  source.Get(AI_MATKEY_NAME, name);
  const std::string text = name.C_Str();
  return (text.empty() || text == AI_DEFAULT_MATERIAL_NAME) &&
         GetNumber(source, kShininess).value_or(0) == 0;
}

SceneMaterial ConvertGltf(const aiMaterial& source, const Color& base) {
  const double metallic = std::clamp(GetNumber(source, kMetallic).value_or(1), 0.0, 1.0);
  double roughness = std::clamp(GetNumber(source, kRoughness).value_or(1), 0.0, 1.0);
  SceneMaterial m;
  m.diffuse = base;
  for (size_t c = 0; c < 3; ++c) {
    m.specular[c] = kDielectricSpecular + metallic * (base[c] - kDielectricSpecular);
  }
  if (const auto glossiness = GetNumber(source, kGlossiness)) {
    roughness = 1 - std::clamp(*glossiness, 0.0, 1.0);
    m.diffuse = GetColor(source, kDiffuse).value_or(base);
    m.specular = GetColor(source, kSpecular).value_or(m.specular);
  }
  m.ambient = Scale(kAmbientShare, m.diffuse);
  m.specular = Scale(1 - roughness, m.specular);
  // Roughness 0 gives infinity, which the clamp takes to 256.
  m.shininess = std::clamp(2 / std::pow(roughness, 4) - 2, 1.0, 256.0);
  return m;
}

}  // namespace

SceneMaterial ConvertMaterial(const aiMaterial& source) {
  if (const auto base = GetColor(source, kBaseColor)) return ConvertGltf(source, *base);
  if (IsPlaceholder(source)) return {};
  SceneMaterial m;
  m.diffuse = GetColor(source, kDiffuse).value_or(kGrey);
  m.ambient = GetColor(source, kAmbient).value_or(kBlack);
  if (m.ambient == Color{1, 1, 1}) m.ambient = Scale(kAmbientShare, m.diffuse);
  m.specular = GetColor(source, kSpecular).value_or(kBlack);
  m.shininess = std::clamp(GetNumber(source, kShininess).value_or(1), 1.0, 256.0);
  return m;
}

}  // namespace shading::sim
