// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vfootprint_mean.h"
#include "Vfootprint_mean_footprint_mean.h"
#include "model/footprint/footprint_mean.h"
#include "tb/dut/light_dut.h"

namespace shading::tb {

// Pins of footprint_mean. The only file that includes Vfootprint_mean.h.
class FootprintMeanDut : public LightDut<Vfootprint_mean> {
 public:
  static constexpr int kLatency = Vfootprint_mean_footprint_mean::Latency;
  struct Input {
    FootprintMean::Light light;
    bool first, last, twice, live;
  };

  void Cycle(bool valid, const Input& input) {
    top().valid_i = valid;
    top().place_i = static_cast<uint8_t>(input.first << 2 | input.last << 1 | input.twice << 0);
    top().live_i = input.live;
    top().diffuse_i = static_cast<uint32_t>(input.light.diffuse.raw());
    top().highlight_i = static_cast<uint32_t>(input.light.highlight.raw());
    top().unlit_i = input.light.unlit;
    top().skipped_i = input.light.skipped;
    Tick();
  }

  FootprintMean::Light output() const {
    return {Diffuse::FromRaw(top().diffuse_o), Highlight::FromRaw(top().highlight_o),
            top().unlit_o != 0, top().skipped_o != 0};
  }
};

}  // namespace shading::tb
