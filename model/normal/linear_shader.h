// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/dot_product.h"
#include "model/normal/duff_normalizer.h"
#include "model/normal/length_recurrence.h"
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
class DuffShader {
 public:
  static constexpr int kLatency = DuffNormalizer::kContract.latency_cycles;

  explicit DuffShader(const NormalSeed& seed) {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j] = LinearRecurrence(seed.quantity[0][j]);
      n_dot_h_or_v_[j] = LinearRecurrence(seed.quantity[1][j]);
      length_[j] = LengthRecurrence(seed.length_square[j]);
    }
  }
  LightCosines At(size_t lane, const LightState& /*light*/) const {
    return DuffNormalizer::Of(n_dot_l_[lane].value(), n_dot_h_or_v_[lane].value(),
                              length_[lane].value());
  }
  void Step() {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j].Step();
      n_dot_h_or_v_[j].Step();
      length_[j].Step();
    }
  }

 private:
  std::array<LinearRecurrence, kLanes> n_dot_l_, n_dot_h_or_v_;
  std::array<LengthRecurrence, kLanes> length_;
};

}  // namespace shading
