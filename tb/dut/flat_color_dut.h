// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vflat_color.h"
#include "Vflat_color_flat_color.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of flat_color. The only file that includes Vflat_color.h.
class FlatColorDut : public IntensityDut<Vflat_color> {
 public:
  static constexpr int kLatency = Vflat_color_flat_color::Latency;

  // The colour of a span does not move: there is no step pin.
  void Cycle(bool load, bool, const ChannelSeed& seed) { IntensityDut::Cycle(load, seed); }
};

}  // namespace shading::tb
