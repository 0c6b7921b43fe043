// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "Vlane_seed.h"
#include "Vlane_seed_0of4.h"
#include "Vlane_seed_1of4.h"
#include "Vlane_seed_2of4.h"
#include "Vlane_seed_3of4.h"
#include "Vlane_seed_lane_seed.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// Pins of lane_seed; Top is the build for one lane. The only file that includes Vlane_seed*.h.
template <typename Top>
class LaneSeedBuildDut {
 public:
  static constexpr int kLatency = Vlane_seed_lane_seed::Latency;

  LaneSeedBuildDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {}

  ChannelSeed Of(const ChannelSeed& seed) {
    DriveChannelSeed(seed, top_->seed_i);
    top_->eval();
    BitReader bits(top_->seed_o);
    ChannelSeed lane;
    lane.curvature = bits.template TakeSigned<IntensityAcc>();
    lane.difference = bits.template TakeSigned<IntensityAcc>();
    lane.second = bits.template TakeSigned<IntensityAcc>();
    lane.first = bits.template TakeSigned<IntensityAcc>();
    return lane;
  }

 private:
  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
};

// The only lane of one, and the four of four: parameters as in tests/unit/intensity/CMakeLists.txt.
using LaneSeedDut = LaneSeedBuildDut<Vlane_seed>;
using LaneSeed0Of4Dut = LaneSeedBuildDut<Vlane_seed_0of4>;
using LaneSeed1Of4Dut = LaneSeedBuildDut<Vlane_seed_1of4>;
using LaneSeed2Of4Dut = LaneSeedBuildDut<Vlane_seed_2of4>;
using LaneSeed3Of4Dut = LaneSeedBuildDut<Vlane_seed_3of4>;

}  // namespace shading::tb
