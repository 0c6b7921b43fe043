// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "model/normal/normal_types.h"
#include "tb/bit_packer.h"

namespace shading::tb {

// Packed structs of normal_pkg.sv, the last field first.
template <int kWords>
void PutQuantitySeed(const QuantitySeed& seed, BitPacker<kWords>& bits) {
  bits.Put(seed.difference);
  bits.Put(seed.first);
}

template <int kWords>
void PutKappa(const Kappa& kappa, BitPacker<kWords>& bits) {
  bits.Put(kappa.exponent, 4);
  bits.Put(kappa.mantissa.raw(), kappa.mantissa.kWidth);
}

// Clock and commands that the recurrences have in common; they have no handshake, so nothing ever
// waits for them. Top is a Verilated class.
template <typename Top>
class RecurrenceDut {
 protected:
  RecurrenceDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {}

  Top& top() { return *top_; }
  const Top& top() const { return *top_; }

  void Cycle(bool load, bool step) {
    top_->load_i = load;
    top_->step_i = step;
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
  }
  static Quantity ValueOf(uint64_t pins) { return Quantity::Wrap(static_cast<int64_t>(pins)); }

 private:
  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
};

}  // namespace shading::tb
