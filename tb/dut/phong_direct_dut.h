// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vphong_direct.h"
#include "Vphong_direct_phong_direct.h"
#include "model/normal/phong_direct.h"
#include "tb/bit_packer.h"
#include "tb/dut/pipeline_dut.h"

namespace shading::tb {

// Pins of phong_direct. The only file that includes Vphong_direct.h.
class PhongDirectDut : public PipelineDut<Vphong_direct> {
 public:
  static constexpr int kLatency = Vphong_direct_phong_direct::Latency;

  void Cycle(bool valid, const std::array<Quantity, 3>& normal) {
    BitPacker<4> bits;
    for (const Quantity component : normal) bits.Put(component);
    bits.Store(top().normal_i);
    PipelineDut::Cycle(valid);
  }
  PixelNormal output() const {
    BitReader bits(top().normal_o);
    PixelNormal normal;
    for (auto& component : normal) component = bits.TakeSigned<PixelNormalComponent>();
    return normal;
  }
};

}  // namespace shading::tb
