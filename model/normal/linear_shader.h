// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/dot_product.h"
#include "model/normal/duff_cosines.h"
#include "model/normal/linear_recurrence.h"
#include "model/normal/normal_types.h"
#include "model/normal/pixel_normal.h"

namespace shading {

// Cosines of the pixels of one span, a part of rtl/normal/normal_shader.sv: At(lane) is the pixel
// of that lane, Step() moves all lanes by one stride.

// phong, phong-taylor: a linear normal and its normalisation.
template <typename Normalizer, int kLanes>
class LinearShader {
 public:
  static constexpr int kLatency =
      Normalizer::kContract.latency_cycles + DotProduct::kContract.latency_cycles;

  explicit LinearShader(const NormalSeed& seed) {
    for (size_t q = 0; q < 3; ++q) {
      for (size_t j = 0; j < kLanes; ++j) line_[q][j] = LinearRecurrence(seed.quantity[q][j]);
    }
  }
  LightCosines At(size_t lane, const LightState& light) const {
    return CosinesOf(
        Normalizer::Of({line_[0][lane].value(), line_[1][lane].value(), line_[2][lane].value()}),
        light);
  }
  void Step() {
    for (auto& quantity : line_) {
      for (LinearRecurrence& line : quantity) line.Step();
    }
  }

 private:
  std::array<std::array<LinearRecurrence, kLanes>, 3> line_;
};

// phong-duff: linear cosines over the root of a quadratic.
template <int kLanes>
class DuffShader : public DuffCosines<LinearRecurrence, kLanes> {
 public:
  explicit DuffShader(const NormalSeed& seed) {
    for (size_t j = 0; j < kLanes; ++j) {
      this->n_dot_l_[j] = LinearRecurrence(seed.quantity[0][j]);
      this->n_dot_h_or_v_[j] = LinearRecurrence(seed.quantity[1][j]);
      this->length_[j] = LengthRecurrence(seed.length_square[j]);
    }
  }
};

}  // namespace shading
