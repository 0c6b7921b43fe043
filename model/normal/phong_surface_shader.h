// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/quad_cosine.h"
#include "model/normal/duff_cosines.h"

namespace shading {

// phong-surface: cosines of the pixels of one span, a part of rtl/normal/normal_shader.sv. The
// linear normal's N.L and N.H are planes of the triangle, its |N|^2 is a surface of second order,
// Duff 1979; DuffCosines divides.
//
// Seeds S1.44, cosines S1.30. N.L within 2^-16.9 on 4096 x 4096 pixels, see
// docs/units/raster/surface_fit.md, for normals of a triangle up to 104 degrees apart; beyond,
// digits are lost with |N|^2, and where it is not positive the cosines are 0.
template <int kLanes>
class PhongSurfaceShader : public DuffCosines<QuadCosine, kLanes> {
 public:
  explicit PhongSurfaceShader(const std::array<CurveSeed, kCurves>& seed) {
    for (size_t j = 0; j < kLanes; ++j) {
      const int lane = static_cast<int>(j);
      this->n_dot_l_[j] = QuadCosine(seed[0], lane, kLanes);
      this->n_dot_h_or_v_[j] = QuadCosine(seed[1], lane, kLanes);
      const CurveSeed square = LaneSeed::Of(seed[2], lane, kLanes);
      this->length_[j] = LengthRecurrence({square.first, square.difference, square.curvature});
    }
  }
};

}  // namespace shading
