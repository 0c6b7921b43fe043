// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_difference.h"
#include "Vquad_difference_quad_difference.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of quad_difference. The only file that includes Vquad_difference.h.
class QuadDifferenceDut : public IntensityDut<Vquad_difference> {
 public:
  static constexpr int kLatency = Vquad_difference_quad_difference::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed) {
    top().step_i = step;
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
