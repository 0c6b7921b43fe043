// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_surface.h"
#include "Vquad_surface_quad_surface.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of quad_surface. The only file that includes Vquad_surface.h.
class QuadSurfaceDut : public IntensityDut<Vquad_surface> {
 public:
  static constexpr int kLatency = Vquad_surface_quad_surface::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed) {
    top().step_i = step;
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
