// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "Vpixel_walker.h"
#include "Vpixel_walker4.h"
#include "Vpixel_walker_pixel_walker.h"
#include "model/flow_pattern.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of pixel_walker as runs in, pixels out; Top is the build with kLanes lanes. The only file
// that includes Vpixel_walker.h and Vpixel_walker4.h.
template <typename Top, int kLanes>
class PixelWalkerBuildDut {
 public:
  static constexpr int kLaneCount = kLanes;
  static constexpr int kLatency = Vpixel_walker_pixel_walker::Latency;

  struct WalkedPixel {
    uint16_t x, y;
    uint32_t z;
    bool last;
  };
  struct Group {
    std::array<WalkedPixel, kLanes> lane;
    uint32_t mask;  // bit j: lane j holds a pixel
    bool step;      // step_o in the cycle in which the group leaves
    int64_t cycle;  // in which the group leaves
  };
  struct Result {
    std::vector<int64_t> taken;   // cycle in which each run is taken
    std::vector<int64_t> loads;   // cycles with load_o
    std::vector<int64_t> offers;  // cycles with pixel_valid_o
    std::vector<Group> groups;
    int64_t stray_steps = 0;  // cycles with step_o in which no group leaves
    std::string failure;      // empty when every group left, unchanged
  };

  PixelWalkerBuildDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {
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
  // Ends when all their groups left; fails when nothing moves for longer than the patterns allow,
  // or after `limit` cycles.
  Result Run(const std::vector<SpanSeed>& runs, const FlowPattern& source, const FlowPattern& sink,
             int64_t limit = int64_t{1} << 40) {
    Result result;
    size_t groups = 0;
    for (const SpanSeed& run : runs) {
      groups += static_cast<size_t>(std::max(1, (run.length + kLanes - 1) / kLanes));
    }
    held_ = false;
    const int64_t patience = 2 * (source.longest_gap() + sink.longest_gap()) + 16;
    int64_t deadline = patience;
    size_t next = 0;
    for (int64_t cycle = 0; next < runs.size() || result.groups.size() < groups; ++cycle) {
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
      }
      if (!result.failure.empty()) return result;
      Tick();
      if (!take) continue;
      ++next;
      Withdraw();
    }
    Settle();
    if (top_->pixel_valid_o) result.failure = "a group is on offer after the last one";
    return result;
  }

 private:
  bool Observe(int64_t cycle, bool take, Result* result) {
    const bool send = top_->pixel_valid_o && top_->pixel_ready_i;
    if (take) result->taken.push_back(cycle);
    if (top_->load_o) result->loads.push_back(cycle);
    if (top_->pixel_valid_o) result->offers.push_back(cycle);
    if (top_->step_o && !send) ++result->stray_steps;
    CheckHeld(cycle, send, result);
    if (send) result->groups.push_back(ReadGroup(cycle));
    return take || send;
  }

  // A group on offer may neither go nor change until it is taken.
  void CheckHeld(int64_t cycle, bool send, Result* result) {
    std::array<uint32_t, (kLanes * kPositionWidth + 31) / 32 + 1> words;
    for (size_t i = 0; i + 1 < words.size(); ++i) {
      const int at = 32 * static_cast<int>(i);
      words[i] = BitsOf(top_->position_o, at, std::min(32, kLanes * kPositionWidth - at));
    }
    words.back() = top_->mask_o;
    if (held_ && (!top_->pixel_valid_o || words != held_words_)) {
      result->failure = "the group on offer changed in cycle " + std::to_string(cycle);
    }
    held_ = top_->pixel_valid_o && !send;
    held_words_ = words;
  }

  // position_t has 49 bits: last 0, z 24:1, y 36:25, x 48:37. Lane 0 is lowest.
  Group ReadGroup(int64_t cycle) const {
    Group group;
    for (int lane = 0; lane < kLanes; ++lane) {
      const int at = lane * kPositionWidth;
      group.lane[static_cast<size_t>(lane)] = {
          static_cast<uint16_t>(BitsOf(top_->position_o, at + 37, 12)),
          static_cast<uint16_t>(BitsOf(top_->position_o, at + 25, 12)),
          BitsOf(top_->position_o, at + 1, 24), BitsOf(top_->position_o, at, 1) != 0};
    }
    group.mask = top_->mask_o;
    group.step = top_->step_o;
    group.cycle = cycle;
    return group;
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

  static constexpr int kPositionWidth = 49;

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
  bool held_ = false;  // the group on offer was not taken
  std::array<uint32_t, (kLanes * kPositionWidth + 31) / 32 + 1> held_words_ = {};  // its bits
};

using PixelWalkerDut = PixelWalkerBuildDut<Vpixel_walker, 1>;
using PixelWalker4Dut = PixelWalkerBuildDut<Vpixel_walker4, 4>;

}  // namespace shading::tb
