// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/frame_work.h"
#include "model/triangle_packet.h"
#include "sim/frame_buffer.h"
#include "sim/options.h"
#include "sim/run_stats.h"
#include "tb/rtl_shading_unit.h"
#include "tb/scoreboard/scoreboard.h"

namespace shading::sim {

// A scene and what the command line says of it, ready to be shaded.
struct Frame {
  std::string scene;
  TriangleList list;
};

// The packets of one SCENE. Throws std::runtime_error, one line.
Frame LoadFrame(const std::string& scene, const Options& options);
std::vector<Frame> LoadFrames(const Options& options);

// Runs the model without the RTL.
RunStats RunModel(const FrameWork& work, const Options& options, tb::PixelConsumer* consumer);

// Runs the RTL alone. Throws std::runtime_error when it does not finish.
RunStats RunRtl(const FrameWork& work, int lanes, const FlowPattern& sink, const std::string& trace,
                tb::PixelConsumer* consumer);

// Runs the RTL against the model.
struct Checked {
  RunStats stats;
  tb::Verdicts verdicts;
  std::vector<tb::SpanRecord> spans;  // filled when asked for
};
Checked RunChecked(const FrameWork& work, int lanes, const FlowPattern& source,
                   const FlowPattern& sink, const std::string& trace, bool record_spans);

// Scene, method, engine, size and what the front end counted.
void Describe(const Frame& frame, const FrameWork& work, int lanes, const char* engine,
              RunStats* stats);

}  // namespace shading::sim
