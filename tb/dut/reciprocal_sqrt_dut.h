// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vreciprocal_sqrt.h"
#include "Vreciprocal_sqrt_reciprocal_sqrt.h"
#include "model/normal/reciprocal_sqrt.h"
#include "tb/dut/pipeline_dut.h"

namespace shading::tb {

// Pins of reciprocal_sqrt. The only file that includes Vreciprocal_sqrt.h.
class ReciprocalSqrtDut : public PipelineDut<Vreciprocal_sqrt> {
 public:
  static constexpr int kLatency = Vreciprocal_sqrt_reciprocal_sqrt::Latency;

  void Cycle(bool valid, SquaredLength q) {
    top().length_sq_i = static_cast<uint64_t>(q.raw());
    PipelineDut::Cycle(valid);
  }
  ReciprocalRoot output() const {
    return {U<1, 24>::FromRaw(top().root_o >> 5), static_cast<int>(top().root_o & 0x1f)};
  }
};

}  // namespace shading::tb
