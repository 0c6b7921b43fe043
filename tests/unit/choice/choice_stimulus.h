// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "model/choice/method_choice.h"
#include "tests/accuracy/choice_search.h"

namespace shading {

inline Vector3 Quantized(const ideal::Vector& v) {
  Vector3 result;
  for (size_t i = 0; i < 3; ++i) result[i] = NormalComponent::Round(v[i]);
  return result;
}

// A triangle, a light and a point as the hardware has them, and what methods show there.
class TestTriangle {
 public:
  TestTriangle(const accuracy::ChoicePoint& point, Lighting lighting)
      : TestTriangle(point.Case(), point.shininess, lighting) {}
  TestTriangle(const accuracy::ChoiceCase& at, double shininess, Lighting lighting)
      : case_(at), lighting_(lighting), shininess_(Shininess::Round(shininess)) {
    std::array<Vector3, 3> normals;
    LightState light = {lighting, Quantized(at.light), Quantized(at.half_or_view), {}};
    light.l_dot_v = CosineOf(light.light, light.half_or_view);
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

  const LightRange& range() const { return range_; }
  Shininess shininess() const { return shininess_; }

  double Shown(const Choice& choice, const Material& material) const {
    return accuracy::ShownCodes(choice.method, Light(choice, material), case_);
  }
  double Error(const Choice& choice, const Material& material) const {
    const accuracy::ChoiceLight light = Light(choice, material);
    return std::abs(accuracy::ShownCodes(choice.method, light, case_) -
                    accuracy::ExactCodes(light, case_));
  }
  // Of the normalised linear normal at the point.
  double SpecularCosine() const {
    const auto weight = case_.Weight();
    ideal::Vector normal = {};
    for (size_t i = 0; i < 3; ++i) {
      normal = ideal::Sum(normal, ideal::Scaled(weight[i], case_.normal[i]));
    }
    normal = ideal::Normalised(normal);
    const double cosine = ideal::Dot(normal, case_.half_or_view);
    if (lighting_ == Lighting::kBlinn) return cosine;
    return 2 * ideal::Dot(normal, case_.light) * cosine -
           ideal::Dot(case_.light, case_.half_or_view);
  }

 private:
  accuracy::ChoiceLight Light(const Choice& choice, const Material& material) const {
    return {material.ambient[0].ToReal(),
            material.diffuse[0].ToReal(),
            material.specular[0].ToReal(),
            material.shininess.ToReal(),
            lighting_,
            choice.dark,
            choice.ambient};
  }

  accuracy::ChoiceCase case_;
  Lighting lighting_;
  Shininess shininess_;
  LightRange range_;
};

inline Material PlainMaterial(double ambient, double diffuse, double specular, double shininess) {
  Material material;
  material.ambient.fill(Reflectance::Round(ambient));
  material.diffuse.fill(Reflectance::Round(diffuse));
  material.specular.fill(Reflectance::Round(specular));
  material.shininess = Shininess::Round(shininess);
  return material;
}

inline Material WithShininess(Material material, Shininess shininess) {
  material.shininess = shininess;
  return material;
}

// Grey; from faint to full scale, some beyond it, some without one of the terms.
inline Material RandomMaterial(std::mt19937& random) {
  const auto term = [&] {
    const double part = std::uniform_real_distribution<double>(0, 1)(random);
    switch (random() % 4) {
      case 0: return 0.0;
      case 1: return std::exp2(-12 * part);
      default: return part;
    }
  };
  double ambient = term(), diffuse = term(), specular = term();
  const double sum = ambient + diffuse + specular;
  if (sum > 1 && random() % 4 != 0) ambient /= sum, diffuse /= sum, specular /= sum;
  Material material = PlainMaterial(ambient, diffuse, specular, 1);
  // Rounding may have passed full scale by an ulp.
  const int64_t excess = material.ambient[0].raw() + material.diffuse[0].raw() +
                         material.specular[0].raw() - (int64_t{1} << Reflectance::kFraction);
  if (excess == 1 || excess == 2) {
    material.ambient.fill(
        Reflectance::FromRaw(std::max<int64_t>(0, material.ambient[0].raw() - excess)));
  }
  return material;
}

inline Tolerance RandomTolerance(std::mt19937& random) {
  return Tolerance::Round(0.25 * std::exp2(static_cast<double>(random() % 6)));
}

// The triangle on the other side of the edge that the point is on: another normal opposite.
inline accuracy::ChoiceCase Neighbor(accuracy::ChoiceCase at, std::mt19937& random) {
  const auto weight = at.Weight();
  size_t opposite = 0;
  while (weight[opposite] > 0) opposite = (opposite + 1) % 3;
  std::normal_distribution<double> gauss;
  const double far = std::exp2(-std::uniform_real_distribution<double>(1, 9)(random));
  for (double& component : at.normal[opposite]) component += far * gauss(random);
  at.normal[opposite] = ideal::Normalised(at.normal[opposite]);
  return at;
}

}  // namespace shading
