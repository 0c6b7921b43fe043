// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "Vquad_cosine.h"
#include "Vquad_cosine_lane3.h"
#include "Vquad_cosine_quad_cosine.h"
#include "model/light/cosine.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of quad_cosine: one lane, and lane 3 of four. The only file that includes Vquad_cosine.h.
template <typename Top>
class QuadCosineBuildDut {
 public:
  static constexpr int kLatency = Vquad_cosine_quad_cosine::Latency;

  // One clock cycle; value() is the output after its edge.
  void Cycle(bool load, bool step, const CurveSeed& seed) {
    BitPacker<6> bits;
    for (const CosineAcc value : {seed.curvature, seed.difference, seed.second, seed.first}) {
      bits.Put(value);
    }
    bits.Store(top_->seed_i);
    top_->load_i = load;
    top_->step_i = step;
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
  }
  Cosine value() const { return Cosine::Wrap(static_cast<int64_t>(top_->cosine_o)); }

 private:
  std::unique_ptr<VerilatedContext> context_ = std::make_unique<VerilatedContext>();
  std::unique_ptr<Top> top_ = std::make_unique<Top>(context_.get());
};
using QuadCosineDut = QuadCosineBuildDut<Vquad_cosine>;
using QuadCosineLane3Dut = QuadCosineBuildDut<Vquad_cosine_lane3>;

}  // namespace shading::tb
