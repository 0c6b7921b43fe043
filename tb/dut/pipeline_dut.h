// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

namespace shading::tb {

// Clock, reset and valid pins of a pipeline that never stalls. Top is a Verilated class.
template <typename Top>
class PipelineDut {
 public:
  bool valid() const { return top_->valid_o; }

 protected:
  PipelineDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {
    top_->rst_ni = 0;
    Cycle(false);
    top_->rst_ni = 1;
  }

  Top& top() { return *top_; }
  const Top& top() const { return *top_; }

  // One clock cycle; the outputs are those after its edge.
  void Cycle(bool valid) {
    top_->valid_i = valid;
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
