// SPDX-License-Identifier: Apache-2.0
#include "model/light/pixel_light.h"

#include <algorithm>

namespace shading {

void PixelLight::SetMaterial(const Material& material) {
  if (material.shininess != material_.shininess) power_ = BlinnSpecular(material.shininess);
  material_ = material;
  has_specular_ = std::any_of(material.specular.begin(), material.specular.end(),
                              [](Reflectance r) { return r.raw() != 0; });
}

}  // namespace shading
