// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "Vquad_split.h"
#include "Vquad_split_quad_split.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of quad_split. The only file that includes Vquad_split.h.
class QuadSplitDut {
 public:
  static constexpr int kLatency = Vquad_split_quad_split::Latency;

  // One clock cycle; code() is the output after its edge.
  void Cycle(bool load, bool step, const ChannelSeed& diffuse, const SplitSeed& split) {
    DriveChannelSeed(diffuse, top_->diffuse_i);
    BitPacker<6> bits;
    bits.Put(split.ambient);
    const ChannelSeed& s = split.specular;
    for (const IntensityAcc value : {s.curvature, s.difference, s.second, s.first}) bits.Put(value);
    bits.Store(top_->split_i);
    top_->load_i = load;
    top_->step_i = step;
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
  }
  uint8_t code() const { return top_->code_o; }

 private:
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Vquad_split> top_ = std::make_unique<Vquad_split>(context_.get());
};

}  // namespace shading::tb
