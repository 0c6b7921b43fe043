// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>
#include <string>
#include <vector>

#include "Vpixel_walker.h"
#include "Vpixel_walker_pixel_walker.h"
#include "model/flow_pattern.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of pixel_walker as runs in, pixels out. The only file that includes Vpixel_walker.h.
class PixelWalkerDut {
 public:
  static constexpr int kLatency = Vpixel_walker_pixel_walker::Latency;

  struct WalkedPixel {
    uint16_t x, y;
    uint32_t z;
    bool last;
    bool step;      // step_o in the cycle in which the pixel leaves
    int64_t cycle;  // in which the pixel leaves
  };
  struct Result {
    std::vector<int64_t> taken;   // cycle in which each run is taken
    std::vector<int64_t> loads;   // cycles with load_o
    std::vector<int64_t> offers;  // cycles with pixel_valid_o
    std::vector<WalkedPixel> pixels;
    int64_t stray_steps = 0;  // cycles with step_o in which no pixel leaves
    std::string failure;      // empty when every pixel left
  };

  PixelWalkerDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Vpixel_walker>(context_.get())) {
    Reset();
  }

  void Reset() {
    top_->run_valid_i = 0;
    top_->pixel_ready_i = 0;
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
  }

  // Offers the runs in order: each appears in a willing cycle of the source and stays until taken.
  // Ends when all their pixels left; fails when nothing moves for longer than the patterns allow,
  // or after `limit` cycles.
  Result Run(const std::vector<SpanSeed>& runs, const FlowPattern& source, const FlowPattern& sink,
             int64_t limit = int64_t{1} << 40) {
    Result result;
    size_t pixels = 0;
    for (const SpanSeed& run : runs) pixels += static_cast<size_t>(run.length);
    const int64_t patience = 2 * (source.longest_gap() + sink.longest_gap()) + 16;
    int64_t deadline = patience;
    size_t next = 0;
    for (int64_t cycle = 0; next < runs.size() || result.pixels.size() < pixels; ++cycle) {
      if (!top_->run_valid_i && next < runs.size() && source.At(cycle)) {
        DriveRun(runs[next], top_->run_i);
        top_->run_valid_i = 1;
      }
      top_->pixel_ready_i = sink.At(cycle);
      Settle();
      const bool take = top_->run_valid_i && top_->run_ready_o;
      if (Observe(cycle, take, &result)) deadline = cycle + patience;
      if (cycle > deadline || cycle >= limit) {
        result.failure = "unfinished in cycle " + std::to_string(cycle);
        return result;
      }
      Tick();
      if (!take) continue;
      ++next;
      Withdraw();
    }
    Settle();
    if (top_->pixel_valid_o) result.failure = "a pixel is on offer after the last one";
    return result;
  }

 private:
  bool Observe(int64_t cycle, bool take, Result* result) {
    const bool send = top_->pixel_valid_o && top_->pixel_ready_i;
    if (take) result->taken.push_back(cycle);
    if (top_->load_o) result->loads.push_back(cycle);
    if (top_->pixel_valid_o) result->offers.push_back(cycle);
    if (top_->step_o && !send) ++result->stray_steps;
    if (send) {
      // position_t: last 0, z 24:1, y 36:25, x 48:37.
      const uint64_t position = top_->position_o;
      result->pixels.push_back({static_cast<uint16_t>(position >> 37 & 0xfff),
                                static_cast<uint16_t>(position >> 25 & 0xfff),
                                static_cast<uint32_t>(position >> 1 & 0xffffff),
                                (position & 1) != 0, top_->step_o != 0, cycle});
    }
    return take || send;
  }

  // A taken run leaves its port; the payload turns into noise.
  void Withdraw() {
    top_->run_valid_i = 0;
    for (int word = 0; word < 4; ++word) top_->run_i[word] = ~top_->run_i[word];
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
  std::unique_ptr<Vpixel_walker> top_;
};

}  // namespace shading::tb
