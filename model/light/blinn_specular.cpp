// SPDX-License-Identifier: Apache-2.0
#include "model/light/blinn_specular.h"

namespace shading {

// The highlight rises with x and 1^n = 1: bisection.
BlinnSpecular::BlinnSpecular(Shininess n) : n_(n.raw()), least_visible_(0) {
  int64_t dark = 0, visible = int64_t{1} << Cosine::kFraction;
  while (visible - dark > 1) {
    const int64_t middle = (dark + visible) / 2;
    (Power(middle).raw() == 0 ? dark : visible) = middle;
  }
  least_visible_ = visible;
}

}  // namespace shading
