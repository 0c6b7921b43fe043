// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_three_term.h"
#include "Vquad_three_term_quad_three_term.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of quad_three_term. The only file that includes Vquad_three_term.h.
class QuadThreeTermDut : public IntensityDut<Vquad_three_term> {
 public:
  static constexpr int kLatency = Vquad_three_term_quad_three_term::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed) {
    top().step_i = step;
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
