// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vblinn_specular.h"
#include "Vblinn_specular_blinn_specular.h"
#include "tb/dut/light_dut.h"

namespace shading::tb {

// Pins of blinn_specular. The only file that includes Vblinn_specular.h.
class BlinnSpecularDut : public LightDut<Vblinn_specular> {
 public:
  static constexpr int kLatency = Vblinn_specular_blinn_specular::Latency;
  struct Input {
    Cosine x;
    Shininess n;
    bool skip = false;
  };
  struct Output {
    Highlight highlight;
    bool skipped = false;
    friend bool operator==(const Output& a, const Output& b) {
      return a.highlight == b.highlight && a.skipped == b.skipped;
    }
  };

  void Cycle(bool valid, const Input& input) {
    top().valid_i = valid;
    top().skip_i = input.skip;
    top().cosine_i = static_cast<uint32_t>(input.x.raw());
    top().shininess_i = static_cast<uint16_t>(input.n.raw());
    Tick();
  }

  Output output() const { return {Highlight::FromRaw(top().highlight_o), top().skipped_o != 0}; }
};

}  // namespace shading::tb
