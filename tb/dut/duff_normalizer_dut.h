// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vduff_normalizer.h"
#include "Vduff_normalizer_duff_normalizer.h"
#include "model/normal/duff_normalizer.h"
#include "tb/dut/pipeline_dut.h"

namespace shading::tb {

struct DuffInput {
  Quantity n_dot_l, n_dot_h_or_v;
  LengthSquare q;
};

// Pins of duff_normalizer. The only file that includes Vduff_normalizer.h.
class DuffNormalizerDut : public PipelineDut<Vduff_normalizer> {
 public:
  static constexpr int kLatency = Vduff_normalizer_duff_normalizer::Latency;

  void Cycle(bool valid, const DuffInput& in) {
    top().n_dot_l_i = Pins(in.n_dot_l);
    top().n_dot_h_or_v_i = Pins(in.n_dot_h_or_v);
    top().length_sq_i = Pins(in.q);
    PipelineDut::Cycle(valid);
  }
  LightCosines output() const {
    return {Cosine::Wrap(static_cast<int64_t>(top().cosines_o >> 32)),
            Cosine::Wrap(static_cast<int64_t>(top().cosines_o))};
  }

 private:
  template <typename Fixed>
  static uint64_t Pins(Fixed value) {
    return static_cast<uint64_t>(value.raw()) & ((uint64_t{1} << Fixed::kWidth) - 1);
  }
};

}  // namespace shading::tb
