// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_midpoint.h"
#include "Vquad_midpoint_quad_midpoint.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of quad_midpoint. The only file that includes Vquad_midpoint.h.
class QuadMidpointDut : public IntensityDut<Vquad_midpoint> {
 public:
  static constexpr int kLatency = Vquad_midpoint_quad_midpoint::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed) {
    top().step_i = step;
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
