// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vpixel_light.h"
#include "Vpixel_light4.h"
#include "Vpixel_light_pixel_light.h"
#include "tb/dut/light_dut.h"

namespace shading::tb {

// Pins of pixel_light with kLanes lanes. The only file that includes Vpixel_light.h and
// Vpixel_light4.h.
template <typename Top, size_t kLanes>
class PixelLightPins : public LightDut<Top> {
 public:
  static constexpr int kLatency = Vpixel_light_pixel_light::Latency;
  struct Input {
    int material = 0;
    std::array<LightCosines, kLanes> cosines;
    bool first = true, last = true, twice = false;  // of the samples of a pixel
    uint32_t live = 0;                              // lanes
  };
  struct Lane {
    PixelCodes codes;
    bool unlit = false, no_highlight = false;
    friend bool operator==(const Lane& a, const Lane& b) {
      return a.codes == b.codes && a.unlit == b.unlit && a.no_highlight == b.no_highlight;
    }
  };
  using Output = std::array<Lane, kLanes>;

  PixelLightPins() { this->top().material_valid_i = 0; }

  // While no pixel is inside. Inputs are samples, and outputs the pixels.
  void SetMean(bool mean) { this->top().is_mean_i = mean; }
  void SetLight(const LightState& light) { DriveLight(light, this->top().light_i); }
  void SetMaterial(int index, const Material& material) {
    this->top().valid_i = 0;
    this->top().material_valid_i = 1;
    this->top().material_index_i = static_cast<uint8_t>(index);
    DriveMaterial(material, this->top().material_i);
    this->Tick();
    this->top().material_valid_i = 0;
  }

  void Cycle(bool valid, const Input& input) {
    this->top().valid_i = valid;
    this->top().index_i = static_cast<uint8_t>(input.material);
    DriveCosines(input.cosines, this->top().cosines_i);
    this->top().place_i = static_cast<uint8_t>(input.first << 2 | input.last << 1 | input.twice);
    this->top().live_i = static_cast<uint8_t>(input.live);
    this->Tick();
  }

  Output output() const {
    Output lanes;
    for (size_t j = 0; j < kLanes; ++j) {
      lanes[j] = {ReadCodes(this->top().code_o, static_cast<int>(j)),
                  (this->top().unlit_o >> j & 1) != 0, (this->top().no_highlight_o >> j & 1) != 0};
    }
    return lanes;
  }
};

using PixelLightDut = PixelLightPins<Vpixel_light, 1>;
using PixelLight4Dut = PixelLightPins<Vpixel_light4, 4>;

}  // namespace shading::tb
