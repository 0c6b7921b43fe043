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

// 255 I, for I with 46 fraction bits.
Intensity RoundToCodes(int64_t light) {
  constexpr int kExtra = kFraction - Intensity::kFraction;
  const int64_t clamped = std::min(light, kOne);
  const int64_t codes = (clamped << 8) - clamped;
  return Intensity::FromRaw((codes + (int64_t{1} << (kExtra - 1))) >> kExtra);
}

}  // namespace

LightCosines VertexLight::Cosines(const Vector3& normal) const {
  return {CosineOf(normal, light_.light), CosineOf(normal, light_.half_or_view)};
}

std::array<Intensity, kChannels> VertexLight::Shade(const LightCosines& cosines,
                                                    const Material& material) const {
  const int64_t diffuse = ClampedRaw(cosines.n_dot_l);
  int64_t highlight = 0;
  if (!IsBlack(material.specular)) {
    highlight =
        SpecularPower::Of(SpecularCosine(light_).Specular(cosines), material.shininess).raw();
  }
  std::array<Intensity, kChannels> intensity;
  for (size_t c = 0; c < intensity.size(); ++c) {
    intensity[c] =
        RoundToCodes((material.ambient[c].raw() << Cosine::kFraction) +
                     material.diffuse[c].raw() * diffuse + material.specular[c].raw() * highlight);
  }
  return intensity;
}

}  // namespace shading
