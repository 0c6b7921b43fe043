// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/choice_triangle.h"

#include <algorithm>
#include <cmath>

namespace shading::accuracy {
namespace {

Vector3 Quantized(const ideal::Vector& v) {
  Vector3 result;
  for (size_t i = 0; i < 3; ++i) result[i] = NormalComponent::Round(v[i]);
  return result;
}

ChoiceLight LightOf(const Choice& choice, const Material& material, Lighting lighting) {
  return {material.ambient[0].ToReal(),
          material.diffuse[0].ToReal(),
          material.specular[0].ToReal(),
          material.shininess.ToReal(),
          lighting,
          choice.dark,
          choice.ambient};
}

}  // namespace

ChoiceTriangle::ChoiceTriangle(const ChoiceCase& at, double shininess, Lighting lighting)
    : case_(at), lighting_(lighting), shininess_(Shininess::Round(shininess)) {
  LightState light = {lighting, Quantized(at.light), Quantized(at.half_or_view), {}};
  light.l_dot_v = CosineOf(light.light, light.half_or_view);
  std::array<Vector3, 3> normals;
  std::array<LightCosines, 3> cosines;
  for (size_t i = 0; i < 3; ++i) {
    normals[i] = Quantized(at.normal[i]);
    cosines[i] = {CosineOf(normals[i], light.light), CosineOf(normals[i], light.half_or_view)};
    case_.normal[i] = ideal::ToReal(normals[i]);
  }
  case_.light = ideal::ToReal(light.light);
  case_.half_or_view = ideal::ToReal(light.half_or_view);
  range_ = MethodChoice::RangeOf(normals, cosines, light);
}

double ChoiceTriangle::Shown(const Choice& choice, const Material& material) const {
  return ShownCodes(choice.method, LightOf(choice, material, lighting_), case_);
}

double ChoiceTriangle::Error(const Choice& choice, const Material& material) const {
  return std::abs(Shown(choice, material) -
                  ExactCodes(LightOf(choice, material, lighting_), case_));
}

double ChoiceTriangle::SpecularCosine() const {
  const auto weight = case_.Weight();
  ideal::Vector normal = {};
  for (size_t i = 0; i < 3; ++i) {
    normal = ideal::Sum(normal, ideal::Scaled(weight[i], case_.normal[i]));
  }
  normal = ideal::Normalised(normal);
  const double cosine = ideal::Dot(normal, case_.half_or_view);
  if (lighting_ == Lighting::kBlinn) return cosine;
  return 2 * ideal::Dot(normal, case_.light) * cosine - ideal::Dot(case_.light, case_.half_or_view);
}

Material PlainMaterial(double ambient, double diffuse, double specular, double shininess) {
  Material material;
  material.ambient.fill(Reflectance::Round(ambient));
  material.diffuse.fill(Reflectance::Round(diffuse));
  material.specular.fill(Reflectance::Round(specular));
  material.shininess = Shininess::Round(shininess);
  return material;
}

Material WithShininess(Material material, Shininess shininess) {
  material.shininess = shininess;
  return material;
}

Material RandomMaterial(std::mt19937& random) {
  const auto term = [&] {
    const double part = std::uniform_real_distribution<double>(0, 1)(random);
    const auto kind = random() % 4;
    return kind == 0 ? 0 : kind == 1 ? std::exp2(-12 * part) : part;
  };
  double ambient = term(), diffuse = term(), specular = term();
  // A little below full scale, which rounding would pass.
  const double scale = 0.9999 / (ambient + diffuse + specular);
  if (scale < 1 && random() % 4 != 0) ambient *= scale, diffuse *= scale, specular *= scale;
  return PlainMaterial(ambient, diffuse, specular, 1);
}

ChoiceCase NeighborOf(ChoiceCase at, std::mt19937& random) {
  const auto weight = at.Weight();
  size_t opposite = 0;
  while (weight[opposite] > 0) opposite = (opposite + 1) % 3;
  std::normal_distribution<double> gauss;
  const double far = std::exp2(-std::uniform_real_distribution<double>(1, 9)(random));
  for (double& component : at.normal[opposite]) component += far * gauss(random);
  at.normal[opposite] = ideal::Normalised(at.normal[opposite]);
  return at;
}

double WorstShare(Method method, Lighting lighting, double tolerance, bool edge, int materials) {
  std::mt19937 random(7);
  double worst = 0;
  for (int i = 0; i < materials; ++i) {
    const Material material = RandomMaterial(random);
    ChoiceRegion region;
    region.least_chord = 0.0005;
    region.edge = edge;
    region.reflected = lighting == Lighting::kPhong;
    region.highlight = std::max(0, static_cast<int>(random() % 12) - 1);
    const auto share = [&](const ChoicePoint& point) {
      const ChoiceTriangle triangle(point, lighting);
      const Material shining = WithShininess(material, triangle.shininess());
      const ChoiceLimit limit = MethodChoice::LimitOf(shining, Tolerance::Round(tolerance));
      const Choice choice = MethodChoice::Of(triangle.range(), limit, lighting);
      if (choice.method != method) return -1.0;
      return triangle.Error(choice, shining) * (edge ? 2 : 1) / tolerance;
    };
    ChoiceSearch search(static_cast<unsigned>(random()));
    worst = std::max(worst, search.Run(region, share, 2, 150).value);
  }
  return worst;
}

}  // namespace shading::accuracy
