// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "Vlength_recurrence.h"
#include "Vlength_recurrence_length_recurrence.h"
#include "model/normal/normal_types.h"
#include "tb/bit_packer.h"

namespace shading::tb {

// Pins of length_recurrence. The only file that includes Vlength_recurrence.h.
class LengthRecurrenceDut {
 public:
  static constexpr int kLatency = Vlength_recurrence_length_recurrence::Latency;

  void Cycle(bool load, bool step, const LengthSeed& seed) {
    BitPacker<5> bits;
    bits.Put(seed.curvature);
    bits.Put(seed.difference);
    bits.Put(seed.first);
    bits.Store(top_->seed_i);
    top_->load_i = load;
    top_->step_i = step;
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
  }
  LengthSquare value() const { return LengthSquare::Wrap(static_cast<int64_t>(top_->value_o)); }

 private:
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Vlength_recurrence> top_ = std::make_unique<Vlength_recurrence>(context_.get());
};

}  // namespace shading::tb
