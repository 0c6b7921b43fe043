// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "tb/dut/pins.h"

namespace shading::tb {

// Pins that the intensity units have in common: a seed and its load command in, a code out. They
// have no handshake, so nothing ever waits for them. Top is a Verilated class.
template <typename Top>
class IntensityDut {
 public:
  uint8_t code() const { return top_->code_o; }

 protected:
  IntensityDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {}

  Top& top() { return *top_; }

  // One clock cycle; code() is the output after its edge.
  void Cycle(bool load, const ChannelSeed& seed) {
    top_->load_i = load;
    DriveChannelSeed(seed, top_->seed_i);
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
  }

 private:
  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
};

}  // namespace shading::tb
