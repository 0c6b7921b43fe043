// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/quad_cosine.h"

namespace shading {

// Cosines of the pixels of one span, a part of rtl/normal/normal_shader.sv: At(lane) is the pixel
// of that lane, Step() moves all lanes by one stride.

// quad-cosine: two surfaces of second order.
template <int kLanes>
class QuadCosineShader {
 public:
  static constexpr int kLatency = 0;

  explicit QuadCosineShader(const std::array<CurveSeed, kCurves>& seed) {
    for (int j = 0; j < kLanes; ++j) {
      n_dot_l_[static_cast<size_t>(j)] = QuadCosine(seed[0], j, kLanes);
      n_dot_h_or_v_[static_cast<size_t>(j)] = QuadCosine(seed[1], j, kLanes);
    }
  }
  LightCosines At(size_t lane, const LightState& /*light*/) const {
    return {n_dot_l_[lane].value(), n_dot_h_or_v_[lane].value()};
  }
  void Step() {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j].Step();
      n_dot_h_or_v_[j].Step();
    }
  }

 private:
  std::array<QuadCosine, kLanes> n_dot_l_, n_dot_h_or_v_;
};

}  // namespace shading
