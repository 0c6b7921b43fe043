// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vgouraud_interpolator.h"
#include "Vgouraud_interpolator_gouraud_interpolator.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of gouraud_interpolator. The only file that includes Vgouraud_interpolator.h.
class GouraudInterpolatorDut : public IntensityDut<Vgouraud_interpolator> {
 public:
  static constexpr int kLatency = Vgouraud_interpolator_gouraud_interpolator::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed) {
    top().step_i = step;
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
