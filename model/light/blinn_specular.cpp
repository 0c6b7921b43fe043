// SPDX-License-Identifier: Apache-2.0
#include "model/light/blinn_specular.h"

namespace shading {

// The highlight rises with x and 1^n = 1: bisection.
BlinnSpecular::BlinnSpecular(Shininess n) : n_(static_cast<uint32_t>(n.raw())), least_visible_(0) {
  int32_t dark = 0, visible = 1 << Cosine::kFraction;
  while (visible - dark > 1) {
    const int32_t middle = dark + (visible - dark) / 2;
    (SpecularMath::Power(middle, n_) == 0 ? dark : visible) = middle;
  }
  least_visible_ = visible;
}

}  // namespace shading
