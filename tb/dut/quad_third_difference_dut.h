// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_third_difference.h"
#include "Vquad_third_difference_quad_third_difference.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of quad_third_difference. The only file that includes Vquad_third_difference.h.
class QuadThirdDifferenceDut : public IntensityDut<Vquad_third_difference> {
 public:
  static constexpr int kLatency = Vquad_third_difference_quad_third_difference::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed) {
    top().step_i = step;
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
