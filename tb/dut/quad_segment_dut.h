// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_segment.h"
#include "Vquad_segment_quad_segment.h"
#include "tb/dut/intensity_dut.h"

namespace shading::tb {

// Pins of quad_segment. The only file that includes Vquad_segment.h.
class QuadSegmentDut : public IntensityDut<Vquad_segment> {
 public:
  static constexpr int kLatency = Vquad_segment_quad_segment::Latency;

  void Cycle(bool load, bool step, const ChannelSeed& seed, Tolerance tolerance) {
    top().step_i = step;
    top().tolerance_i = static_cast<uint16_t>(tolerance.raw());
    IntensityDut::Cycle(load, seed);
  }
};

}  // namespace shading::tb
