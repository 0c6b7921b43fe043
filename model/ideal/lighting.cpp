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

Light::Cosines Light::CosinesOf(const Vector& normal) const {
  return {Dot(normal, light_), Dot(normal, lighting_ == Lighting::kBlinn ? half_ : view_)};
}

double Light::SpecularCosine(const Cosines& cosines) const {
  if (lighting_ == Lighting::kBlinn) return cosines.n_dot_h_or_v;
  return 2 * cosines.n_dot_l * cosines.n_dot_h_or_v - Dot(light_, view_);
}

Light::Terms Light::TermsOf(const Cosines& cosines, const Material& material) const {
  const double highlight =
      std::pow(std::clamp(SpecularCosine(cosines), 0.0, 1.0), material.shininess.ToReal());
  Terms terms;
  for (size_t c = 0; c < terms.ambient.size(); ++c) {
    terms.ambient[c] = 255 * material.ambient[c].ToReal();
    terms.diffuse[c] = 255 * material.diffuse[c].ToReal() * cosines.n_dot_l;
    terms.specular[c] = 255 * material.specular[c].ToReal() * highlight;
  }
  return terms;
}

Light::Terms Light::LitTermsOf(const Cosines& cosines, const Material& material) const {
  Terms terms = TermsOf(cosines, material);
  for (size_t c = 0; c < terms.diffuse.size(); ++c) {
    terms.diffuse[c] = 255 * material.diffuse[c].ToReal() * std::clamp(cosines.n_dot_l, 0.0, 1.0);
  }
  return terms;
}

Rgb Light::ShadeCosines(const Cosines& cosines, const Material& material) const {
  const Terms terms = LitTermsOf(cosines, material);
  return Clamped(Sum(terms.ambient, Sum(terms.diffuse, terms.specular)));
}

Rgb Light::Shade(const Vector& normal, const Material& material) const {
  return ShadeCosines(CosinesOf(normal), material);
}

}  // namespace shading::ideal
