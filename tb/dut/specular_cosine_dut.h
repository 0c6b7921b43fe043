// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vspecular_cosine.h"
#include "Vspecular_cosine_specular_cosine.h"
#include "tb/dut/light_dut.h"

namespace shading::tb {

// Pins of specular_cosine. The only file that includes Vspecular_cosine.h.
class SpecularCosineDut : public LightDut<Vspecular_cosine> {
 public:
  static constexpr int kLatency = Vspecular_cosine_specular_cosine::Latency;
  using Input = LightCosines;
  struct Output {
    Diffuse diffuse;
    bool unlit = false;
    Cosine specular;
    friend bool operator==(const Output& a, const Output& b) {
      return a.diffuse == b.diffuse && a.unlit == b.unlit && a.specular == b.specular;
    }
  };

  // While no pixel is inside.
  void SetLight(const LightState& light) { DriveLight(light, top().light_i); }

  void Cycle(bool valid, const Input& cosines) {
    top().valid_i = valid;
    DriveCosines<1>({cosines}, top().cosines_i);
    Tick();
  }

  Output output() const {
    return {Diffuse::FromRaw(top().diffuse_o), top().unlit_o != 0, Cosine::Wrap(top().specular_o)};
  }
};

}  // namespace shading::tb
