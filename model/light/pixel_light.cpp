// SPDX-License-Identifier: Apache-2.0
#include "model/light/pixel_light.h"

#include <algorithm>

namespace shading {

PixelLight::PixelLight(const LightState& light)
    : cosine_(light), power_(Shininess::FromRaw(1 << Shininess::kFraction)) {
  constants_.phong = cosine_.phong();
  constants_.l_dot_v = cosine_.l_dot_v();
}

void PixelLight::SetMaterial(const Material& material, bool highlight) {
  if (material.shininess != material_.shininess) power_ = BlinnSpecular(material.shininess);
  material_ = material;
  constants_.has_specular =
      highlight && std::any_of(material.specular.begin(), material.specular.end(),
                               [](Reflectance r) { return r.raw() != 0; });
  constants_.shininess = power_.raw_shininess();
  constants_.least_visible = static_cast<int32_t>(power_.least_visible().raw());
  for (size_t c = 0; c < constants_.channel.size(); ++c) {
    constants_.channel[c] = RgbCombine::RawChannel(material, c);
  }
}

}  // namespace shading
