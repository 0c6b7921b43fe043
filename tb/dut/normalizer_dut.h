// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/light/light_types.h"
#include "model/normal/normal_types.h"
#include "tb/bit_packer.h"
#include "tb/dut/pipeline_dut.h"

namespace shading::tb {

// Pins of a pipeline that takes an interpolated normal and gives the normal of a pixel. Top is a
// Verilated class.
template <typename Top>
class NormalizerDut : public PipelineDut<Top> {
 public:
  void Cycle(bool valid, const std::array<Quantity, 3>& normal) {
    BitPacker<4> bits;
    for (const Quantity component : normal) bits.Put(component);
    bits.Store(this->top().normal_i);
    PipelineDut<Top>::Cycle(valid);
  }
  PixelNormal output() const {
    BitReader bits(this->top().normal_o);
    PixelNormal normal;
    for (auto& component : normal) {
      component = bits.template TakeSigned<PixelNormalComponent>();
    }
    return normal;
  }
};

}  // namespace shading::tb
