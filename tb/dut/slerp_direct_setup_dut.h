// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "Vslerp_direct_setup.h"
#include "Vslerp_direct_setup_slerp_direct_setup.h"
#include "model/flow_pattern.h"
#include "tb/dut/arc_pins.h"
#include "tb/dut/recurrence_dut.h"

namespace shading::tb {

// Pins of slerp_direct_setup as seeds in, arcs out. The only file that includes
// Vslerp_direct_setup.h.
class SlerpDirectSetupDut {
 public:
  static constexpr int kLatency = Vslerp_direct_setup_slerp_direct_setup::Latency;
  static constexpr int kInterval = Vslerp_direct_setup_slerp_direct_setup::Interval;

  static constexpr size_t kRunWords = 5;

  struct Seed {
    std::array<QuantitySeed, 3> quantity;
    Kappa kappa;
    std::array<uint32_t, kRunWords> run;  // travels along unread; 138 bits
  };
  struct TimedArc {
    SpanArc arc;
    std::array<uint32_t, kRunWords> run;
    int64_t offered;  // first cycle with seed_valid_o
    int64_t taken;
  };
  struct Result {
    std::vector<int64_t> seeds;  // cycle in which each is taken
    std::vector<TimedArc> arcs;
    std::string failure;  // empty when every arc was taken and the unit is empty
  };

  SlerpDirectSetupDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Vslerp_direct_setup>(context_.get())) {
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }

  Result Run(const std::vector<Seed>& seeds, const FlowPattern& seed_flow,
             const FlowPattern& arc_flow) {
    Result result;
    const int64_t limit = 200 + static_cast<int64_t>(seeds.size()) * 64;
    bool held = false;
    int64_t offered = 0;
    for (int64_t cycle = 0; result.arcs.size() < seeds.size(); ++cycle) {
      if (!top_->seed_valid_i && result.seeds.size() < seeds.size() && seed_flow.At(cycle)) {
        Drive(seeds[result.seeds.size()]);
        top_->seed_valid_i = 1;
      }
      top_->seed_ready_i = arc_flow.At(cycle);
      Settle();
      const bool take_seed = top_->seed_valid_i && top_->seed_ready_o;
      if (take_seed) result.seeds.push_back(cycle);
      if (!held && top_->seed_valid_o) offered = cycle;
      if (held && !top_->seed_valid_o) result.failure = "an arc on offer went away";
      held = top_->seed_valid_o && !top_->seed_ready_i;
      if (top_->seed_valid_o && top_->seed_ready_i) {
        result.arcs.push_back({ReadArc(top_->arc_o), ReadRun(), offered, cycle});
      }
      if (cycle > limit) result.failure = "unfinished in cycle " + std::to_string(cycle);
      if (!result.failure.empty()) return result;
      Tick();
      if (take_seed) {
        top_->seed_valid_i = 0;
        for (int word = 0; word < 8; ++word) top_->quantity_i[word] = ~top_->quantity_i[word];
        top_->kappa_i = ~top_->kappa_i & ((uint64_t{1} << 33) - 1);
      }
    }
    Settle();
    if (top_->busy_o || top_->seed_valid_o) result.failure = "not empty after the last arc";
    return result;
  }

 private:
  static constexpr uint32_t kTopRun = (1u << 10) - 1;  // lit_run_t has 138 bits

  void Drive(const Seed& seed) {
    BitPacker<8> quantities;
    for (const QuantitySeed& quantity : seed.quantity) PutQuantitySeed(quantity, quantities);
    quantities.Store(top_->quantity_i);
    top_->kappa_i = static_cast<uint64_t>(seed.kappa.mantissa.raw()) << 4 |
                    static_cast<uint64_t>(seed.kappa.exponent);
    for (size_t word = 0; word < kRunWords; ++word) top_->run_i[word] = seed.run[word];
    top_->run_i[kRunWords - 1] &= kTopRun;
  }
  std::array<uint32_t, kRunWords> ReadRun() const {
    return {top_->run_o[0], top_->run_o[1], top_->run_o[2], top_->run_o[3], top_->run_o[4]};
  }

  void Settle() {
    top_->clk_i = 0;
    top_->eval();
  }
  void Tick() {
    Settle();
    top_->clk_i = 1;
    top_->eval();
  }

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Vslerp_direct_setup> top_;
};

}  // namespace shading::tb
