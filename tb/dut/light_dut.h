// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "tb/dut/light_pins.h"

namespace shading::tb {

// Pins that the light units have in common: pipelines without a handshake back. Top is a Verilated
// class.
template <typename Top>
class LightDut {
 public:
  // Output of the input that came kLatency cycles ago, after the edge of the last Cycle.
  bool valid() const { return top_->valid_o; }

  // Empties the pipeline.
  void Reset() {
    top_->valid_i = 0;
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }

 protected:
  LightDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {
    Reset();
  }

  Top& top() { return *top_; }
  const Top& top() const { return *top_; }

  void Tick() {
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
