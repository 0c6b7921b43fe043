// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vtaylor_normalizer.h"
#include "Vtaylor_normalizer_taylor_normalizer.h"
#include "model/normal/taylor_normalizer.h"
#include "tb/bit_packer.h"
#include "tb/dut/pipeline_dut.h"

namespace shading::tb {

// Pins of taylor_normalizer. The only file that includes Vtaylor_normalizer.h.
class TaylorNormalizerDut : public PipelineDut<Vtaylor_normalizer> {
 public:
  static constexpr int kLatency = Vtaylor_normalizer_taylor_normalizer::Latency;

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
