// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vslerp_direct.h"
#include "Vslerp_direct_lane3.h"
#include "Vslerp_direct_slerp_direct.h"
#include "model/light/light_types.h"
#include "tb/dut/arc_pins.h"
#include "tb/dut/pipeline_dut.h"

namespace shading::tb {

// Pins of slerp_direct, for the lane with other parameters too. The only file that includes
// Vslerp_direct*.h.
template <typename Top, int kLaneIndex, int kLaneCount>
class SlerpDirectLaneDut : public PipelineDut<Top> {
 public:
  static constexpr int kLatency = Vslerp_direct_slerp_direct::Latency;
  static constexpr int kLane = kLaneIndex, kLanes = kLaneCount;  // as in CMakeLists.txt

  // One clock cycle; output() is that after its edge.
  void Cycle(bool load, bool step, bool valid, const SpanArc& arc) {
    this->top().load_i = load;
    this->top().step_i = step;
    DriveArc(arc, this->top().arc_i);
    PipelineDut<Top>::Cycle(valid);
  }
  PixelNormal output() const {
    BitReader bits(this->top().normal_o);
    PixelNormal normal;
    for (auto& value : normal) value = bits.template TakeSigned<PixelNormalComponent>();
    return normal;
  }
};

using SlerpDirectDut = SlerpDirectLaneDut<Vslerp_direct, 0, 1>;
using SlerpDirectLane3Dut = SlerpDirectLaneDut<Vslerp_direct_lane3, 3, 4>;

}  // namespace shading::tb
