// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/lighting.h"

#include <algorithm>
#include <cmath>

namespace shading::ideal {

Vector ToReal(const shading::Vector3& v) { return {v[0].ToReal(), v[1].ToReal(), v[2].ToReal()}; }

double Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector Sum(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Vector Scaled(double factor, const Vector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}

Vector Normalised(const Vector& v) {
  const double length = std::sqrt(Dot(v, v));
  return length > 0 ? Scaled(1 / length, v) : Vector{};
}

std::optional<Vector> MeanNormal(const Vector& sum) {
  constexpr double kLeastSquare = 1.0 / 1024;
  if (Dot(sum, sum) < kLeastSquare) return std::nullopt;
  return Normalised(sum);
}

Rgb Clamped(const Rgb& codes) {
  Rgb clamped;
  for (size_t c = 0; c < codes.size(); ++c) clamped[c] = std::clamp(codes[c], 0.0, 255.0);
  return clamped;
}

Light::Light(const FrameState& frame)
    : lighting_(frame.lighting),
      light_(ToReal(frame.light)),
      half_(ToReal(frame.half)),
      view_(ToReal(frame.view)) {}

double Light::SpecularCosine(const Vector& normal) const {
  if (lighting_ == Lighting::kBlinn) return Dot(normal, half_);
  const Vector reflected = Sum(Scaled(2 * Dot(normal, light_), normal), Scaled(-1, light_));
  return Dot(reflected, view_);
}

Rgb Light::Shade(const Vector& normal, const Material& material) const {
  const double diffuse = std::clamp(Dot(normal, light_), 0.0, 1.0);
  const double highlight =
      std::pow(std::clamp(SpecularCosine(normal), 0.0, 1.0), material.shininess.ToReal());
  Rgb codes;
  for (size_t c = 0; c < codes.size(); ++c) {
    codes[c] = 255 * (material.ambient[c].ToReal() + material.diffuse[c].ToReal() * diffuse +
                      material.specular[c].ToReal() * highlight);
  }
  return Clamped(codes);
}

}  // namespace shading::ideal
