// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "model/footprint/aniso_footprint.h"
#include "model/footprint/footprint_mean.h"
#include "model/light/blinn_specular.h"
#include "model/light/dot_product.h"
#include "model/light/rgb_combine.h"
#include "model/light/specular_cosine.h"
#include "model/normal/phong_direct.h"

namespace shading {

// The mean light of a pixel: its samples, each normalised and lit, for the material that was set
// last.
class FootprintLight {
 public:
  explicit FootprintLight(const LightState& light)
      : light_(light), cosine_(light), power_(Shininess::FromRaw(1 << Shininess::kFraction)) {}

  void SetMaterial(const Material& material) {
    const auto raw = static_cast<uint32_t>(material.shininess.raw());
    if (raw != power_.raw_shininess()) power_ = BlinnSpecular(material.shininess);
    material_ = material;
    has_specular_ = std::any_of(material.specular.begin(), material.specular.end(),
                                [](Reflectance r) { return r.raw() != 0; });
  }
  PixelCodes CodesOf(const FootprintMean::Light& mean) const {
    return RgbCombine::Of(mean.diffuse, mean.highlight, material_);
  }

  // Of the pixel whose centre has this normal.
  FootprintMean::Light Mean(FootprintPattern pattern, const std::array<Quantity, 3>& centre,
                            AnisoFootprint* samples) const {
    FootprintMean mean;
    const int count = SampleCount(pattern);
    for (int i = 0; i < count; ++i) {
      const FootprintSample sample = samples->Next(i, centre);
      if (sample.live) mean.Add(Of(sample.normal), sample.weight);
    }
    return mean.Mean();
  }

 private:
  FootprintMean::Light Of(const std::array<Quantity, 3>& normal) const {
    const PixelNormal unit = PhongDirect::Of(normal);
    const LightCosines cosines = {DotProduct::Of(unit, light_.light),
                                  DotProduct::Of(unit, light_.half_or_view)};
    FootprintMean::Light light;
    light.diffuse = SpecularCosine::DiffuseOf(cosines);
    light.unlit = SpecularCosine::Unlit(cosines);
    if (!has_specular_) return light;
    const Cosine specular = cosine_.Specular(cosines);
    light.highlight = power_.Of(specular);
    light.skipped = !BlinnSpecular::Lit(specular);
    return light;
  }

  LightState light_;
  SpecularCosine cosine_;
  BlinnSpecular power_;
  Material material_;
  bool has_specular_ = false;
};

}  // namespace shading
