// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vdot_product.h"
#include "Vdot_product_dot_product.h"
#include "tb/dut/light_dut.h"

namespace shading::tb {

// Pins of dot_product. The only file that includes Vdot_product.h.
class DotProductDut : public LightDut<Vdot_product> {
 public:
  static constexpr int kLatency = Vdot_product_dot_product::Latency;
  struct Input {
    PixelNormal normal;
    Vector3 vector;
  };

  void Cycle(bool valid, const Input& input) {
    top().valid_i = valid;
    DriveVector(input.normal, top().normal_i);
    DriveVector(input.vector, top().vector_i);
    Tick();
  }

  Cosine output() const { return Cosine::Wrap(top().cosine_o); }
};

}  // namespace shading::tb
