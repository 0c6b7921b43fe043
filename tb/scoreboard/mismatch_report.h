// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/frame_work.h"
#include "tb/scoreboard/scoreboard.h"

namespace shading::tb {

// What a person needs to find the fault: triangle, span, pixel, channel, both values, both cycles,
// the operands on each side. Runs the frame again to read the hardware's operands and to write a
// waveform of the cycles around the first difference.
std::string ReportMismatch(const FrameWork& work, int lanes, const Verdicts& verdicts,
                           const FlowPattern& source, const FlowPattern& sink,
                           const std::string& waveform);

}  // namespace shading::tb
