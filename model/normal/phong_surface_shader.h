// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/quad_cosine.h"
#include "model/normal/duff_normalizer.h"
#include "model/normal/length_recurrence.h"

namespace shading {

// phong-surface: cosines of the pixels of one span, a part of rtl/normal/normal_shader.sv. The
// linear normal's N.L and N.H are planes of the triangle, its |N|^2 is a surface of second order,
// Duff 1979; duff_normalizer divides. At(lane) is the pixel of that lane, Step() moves all lanes by
// one stride.
//
// Seeds S1.44, cosines S1.30. N.L within 2^-16.9 on 4096 x 4096 pixels, see
// docs/units/raster/surface_fit.md, for normals of a triangle up to 104 degrees apart; beyond,
// digits are lost with |N|^2, and where it is not positive the cosines are 0.
template <int kLanes>
class PhongSurfaceShader {
 public:
  static constexpr int kLatency = DuffNormalizer::kContract.latency_cycles;

  explicit PhongSurfaceShader(const std::array<CurveSeed, kCurves>& seed) {
    for (size_t j = 0; j < kLanes; ++j) {
      const int lane = static_cast<int>(j);
      n_dot_l_[j] = QuadCosine(seed[0], lane, kLanes);
      n_dot_h_or_v_[j] = QuadCosine(seed[1], lane, kLanes);
      const CurveSeed square = LaneSeed::Of(seed[2], lane, kLanes);
      length_[j] = LengthRecurrence({square.first, square.difference, square.curvature});
    }
  }
  LightCosines At(size_t lane, const LightState& /*light*/) const {
    return DuffNormalizer::Of(ToQuantity(n_dot_l_[lane].value()),
                              ToQuantity(n_dot_h_or_v_[lane].value()), length_[lane].value());
  }
  void Step() {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j].Step();
      n_dot_h_or_v_[j].Step();
      length_[j].Step();
    }
  }

 private:
  static Quantity ToQuantity(Cosine cosine) {
    constexpr int kAlign = Quantity::kFraction - Cosine::kFraction;
    return Quantity::FromRaw(cosine.raw() * (int64_t{1} << kAlign));
  }

  std::array<QuadCosine, kLanes> n_dot_l_, n_dot_h_or_v_;
  std::array<LengthRecurrence, kLanes> length_;
};

}  // namespace shading
