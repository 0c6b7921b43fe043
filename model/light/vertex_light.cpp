// SPDX-License-Identifier: Apache-2.0
#include "model/light/vertex_light.h"

#include <algorithm>

#include "model/light/specular_cosine.h"
#include "model/light/specular_power.h"

namespace shading {
namespace {

constexpr int kFraction = Reflectance::kFraction + Cosine::kFraction;
constexpr int64_t kOne = int64_t{1} << kFraction;

bool IsBlack(const Rgb& colour) {
  return std::all_of(colour.begin(), colour.end(), [](Reflectance r) { return r.raw() == 0; });
}

// 255 I in codes, for I with 46 fraction bits.
int64_t RoundToCodes(int64_t light) {
  constexpr int kExtra = kFraction - Intensity::kFraction;
  return ((light << 8) - light + (int64_t{1} << (kExtra - 1))) >> kExtra;
}

}  // namespace

LightCosines VertexLight::Cosines(const Vector3& normal) const {
  return {CosineOf(normal, light_.light), CosineOf(normal, light_.half_or_view)};
}

int64_t VertexLight::HighlightRaw(const LightCosines& cosines, const Material& material) const {
  if (IsBlack(material.specular)) return 0;
  return SpecularPower::Of(SpecularCosine(light_).Specular(cosines), material.shininess).raw();
}

std::array<Intensity, kChannels> VertexLight::Shade(const LightCosines& cosines,
                                                    const Material& material) const {
  const int64_t diffuse = ClampedRaw(cosines.n_dot_l);
  const int64_t highlight = HighlightRaw(cosines, material);
  std::array<Intensity, kChannels> intensity;
  for (size_t c = 0; c < intensity.size(); ++c) {
    const int64_t light = (material.ambient[c].raw() << Cosine::kFraction) +
                          material.diffuse[c].raw() * diffuse +
                          material.specular[c].raw() * highlight;
    intensity[c] = Intensity::FromRaw(RoundToCodes(std::min(light, kOne)));
  }
  return intensity;
}

Intensity VertexLight::Ambient(const Material& material, size_t channel) {
  const int64_t light = material.ambient[channel].raw() << Cosine::kFraction;
  return Intensity::FromRaw(RoundToCodes(std::min(light, kOne)));
}

VertexLight::Terms VertexLight::ShadeTerms(const LightCosines& cosines,
                                           const Material& material) const {
  const int64_t highlight = HighlightRaw(cosines, material);
  // Saturated cosines and reflectances over 1 would leave the format.
  constexpr int64_t kMostCosine = int64_t{1} << Cosine::kFraction;
  const int64_t n_dot_l = std::clamp(cosines.n_dot_l.raw(), -kMostCosine, kMostCosine);
  const auto term = [](int64_t light) {
    return SignedIntensity::FromRaw(RoundToCodes(std::clamp(light, -kOne, kOne)));
  };
  Terms terms;
  for (size_t c = 0; c < terms.diffuse.size(); ++c) {
    terms.diffuse[c] = term(material.diffuse[c].raw() * n_dot_l);
    terms.specular[c] = term(material.specular[c].raw() * highlight);
  }
  return terms;
}

}  // namespace shading
