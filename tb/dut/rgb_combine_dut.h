// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vrgb_combine.h"
#include "Vrgb_combine_rgb_combine.h"
#include "tb/dut/light_dut.h"

namespace shading::tb {

// Pins of rgb_combine. The only file that includes Vrgb_combine.h.
class RgbCombineDut : public LightDut<Vrgb_combine> {
 public:
  static constexpr int kLatency = Vrgb_combine_rgb_combine::Latency;
  struct Input {
    Diffuse diffuse;
    Highlight highlight;
    Material material;
  };

  void Cycle(bool valid, const Input& input) {
    top().valid_i = valid;
    top().diffuse_i = static_cast<uint32_t>(input.diffuse.raw());
    top().highlight_i = static_cast<uint32_t>(input.highlight.raw());
    DriveMaterial(input.material, top().material_i);
    Tick();
  }

  PixelCodes output() const { return ReadCodes(top().code_o, 0); }
};

}  // namespace shading::tb
