// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "Vmethod_choice.h"
#include "Vmethod_choice_method_choice.h"
#include "model/choice/choice_types.h"
#include "tb/dut/light_pins.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of method_choice. The only file that includes Vmethod_choice*.h.
class MethodChoiceDut {
 public:
  static constexpr int kLatency = Vmethod_choice_method_choice::Latency;

  MethodChoiceDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Vmethod_choice>(context_.get())) {}

  Choice Of(const LightRange& range, const ChoiceLimit& limit, Lighting lighting) {
    BitPacker<3> range_bits;
    for (const RangeCosine cosine :
         {range.specular_high, range.specular_low, range.n_dot_l_high, range.n_dot_l_low}) {
      range_bits.Put(cosine);
    }
    range_bits.Put(range.turn.raw(), Turn::kWidth);
    StoreBits(range_bits, top_->range_i);
    BitPacker<2> limit_bits;
    limit_bits.Put(limit.channels, kChannels);
    limit_bits.Put(limit.below_full_dark, 1);
    limit_bits.Put(limit.below_full, 1);
    limit_bits.Put(limit.shininess.raw(), Shininess::kWidth);
    for (const Log log : {limit.shininess_log, limit.specular, limit.diffuse}) limit_bits.Put(log);
    StoreBits(limit_bits, top_->limit_i);
    top_->lighting_i = lighting == Lighting::kPhong;
    top_->eval();
    return Read();
  }

 private:
  Choice Read() const {
    Choice choice;
    choice.channels = static_cast<uint8_t>(BitsOf(top_->choice_o, 0, kChannels));
    choice.ambient = BitsOf(top_->choice_o, kChannels, 1) != 0;
    choice.dark = BitsOf(top_->choice_o, kChannels + 1, 1) != 0;
    choice.method = static_cast<Method>(BitsOf(top_->choice_o, kChannels + 2, kMethodWidth));
    return choice;
  }

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Vmethod_choice> top_;
};

}  // namespace shading::tb
