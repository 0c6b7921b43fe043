// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/choice_error.h"

#include <algorithm>
#include <cmath>

namespace shading::accuracy {
namespace {

using ideal::Dot;
using ideal::Normalised;
using ideal::Scaled;
using ideal::Sum;
using ideal::Vector;

struct Cosines {
  double n_dot_l, n_dot_h_or_v;
};

Cosines CosinesOf(const Vector& normal, const ChoiceCase& at) {
  return {Dot(normal, at.light), Dot(normal, at.half_or_view)};
}

double SpecularCosine(const ChoiceLight& light, const Cosines& cosines, const ChoiceCase& at) {
  if (light.lighting == Lighting::kBlinn) return cosines.n_dot_h_or_v;
  return 2 * cosines.n_dot_l * cosines.n_dot_h_or_v - Dot(at.light, at.half_or_view);
}

double Codes(const ChoiceLight& light, const Cosines& cosines, const ChoiceCase& at) {
  double sum = light.ambient;
  if (!light.lightless) sum += light.diffuse * std::clamp(cosines.n_dot_l, 0.0, 1.0);
  if (!light.dark && light.specular > 0) {
    const double cosine = std::min(SpecularCosine(light, cosines, at), 1.0);
    if (cosine > 0) sum += light.specular * std::exp(light.shininess * std::log(cosine));
  }
  return 255 * std::min(sum, 1.0);
}

Vector Over(const std::array<Vector, 3>& normal, const std::array<double, 3>& weight) {
  Vector sum = {};
  for (size_t i = 0; i < 3; ++i) sum = Sum(sum, Scaled(weight[i], normal[i]));
  return Normalised(sum);
}

// The quadratic through the values of the corners and of the middles, opposite each corner.
template <typename ValueOf>
double Quadratic(const ChoiceCase& at, const ValueOf& value) {
  const auto weight = at.Weight();
  double sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    sum += weight[i] * (2 * weight[i] - 1) * value(at.normal[i]);
    sum += 4 * weight[j] * weight[k] * value(Normalised(Sum(at.normal[j], at.normal[k])));
  }
  return sum;
}

}  // namespace

std::array<double, 3> ChoiceCase::Weight() const {
  std::array<double, 3> weight;
  for (size_t i = 0; i < 3; ++i) weight[i] = (1 - along) * end[0][i] + along * end[1][i];
  return weight;
}

double ExactCodes(const ChoiceLight& light, const ChoiceCase& at) {
  ChoiceLight whole = light;
  whole.dark = whole.lightless = false;
  return Codes(whole, CosinesOf(Over(at.normal, at.Weight()), at), at);
}

double ShownCodes(Method method, const ChoiceLight& light, const ChoiceCase& at) {
  const auto lit = [&](const Vector& normal) { return Codes(light, CosinesOf(normal, at), at); };
  switch (method) {
    case Method::kFlat: return lit(Over(at.normal, {1, 1, 1}));
    case Method::kGouraud: {
      const auto weight = at.Weight();
      double sum = 0;
      for (size_t i = 0; i < 3; ++i) sum += weight[i] * lit(at.normal[i]);
      return sum;
    }
    case Method::kQuad: return std::clamp(Quadratic(at, lit), 0.0, 255.0);
    case Method::kQuadCosine: {
      const auto n_dot_l = [&](const Vector& normal) { return Dot(normal, at.light); };
      const auto other = [&](const Vector& normal) { return Dot(normal, at.half_or_view); };
      return Codes(light, {Quadratic(at, n_dot_l), Quadratic(at, other)}, at);
    }
    default: return lit(Over(at.normal, at.Weight()));
  }
}

}  // namespace shading::accuracy
