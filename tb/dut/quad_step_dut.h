// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_step.h"
#include "Vquad_step_quad_step.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of quad_step. The only file that includes Vquad_step.h.
class QuadStepDut : public IntensityDut<Vquad_step> {
 public:
  static constexpr int kLatency = Vquad_step_quad_step::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed) {
    top().step_i = step;
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
