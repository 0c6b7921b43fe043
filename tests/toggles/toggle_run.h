// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/frame_work.h"
#include "model/shading_unit.h"
#include "model/triangle_packet.h"
#include "tb/toggle_count.h"

namespace shading::test {

inline constexpr Tolerance kOneCode = Tolerance::FromRaw(int64_t{1} << Tolerance::kFraction);

FrameWork WorkOf(const TriangleList& list, Method method, Tolerance tolerance = kOneCode);

// What the build with all methods did to shade one frame, one lane.
struct TracedFrame {
  std::vector<tb::SignalToggles> signals;
  int64_t cycles = 0;
  int64_t trace_bytes = 0;  // of its waveform
  Counters counters;

  int64_t toggles() const;
};
// Throws std::runtime_error when a pixel, a cycle or a counter is not the model's.
TracedFrame Trace(const FrameWork& work);

}  // namespace shading::test
