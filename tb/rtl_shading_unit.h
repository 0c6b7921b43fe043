// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "model/flow_pattern.h"
#include "model/frame_work.h"
#include "model/shading_unit.h"

namespace shading::tb {

// Receives the pixels of a simulation, many at a time: one virtual call for some thousand pixels.
class PixelConsumer {
 public:
  virtual ~PixelConsumer() = default;
  // Returns false to end the simulation.
  virtual bool Consume(const TimedPixel* pixels, size_t count) = 0;
};

// What to record beside the pixels.
struct Observation {
  std::string trace;  // .fst file; empty: no waveform
  int64_t first = 0;  // cycles that go into the waveform
  int64_t last = INT64_MAX;
  int64_t probe_span = -1;  // span whose seed is to be read out of the hardware
};

struct RtlResult {
  int64_t pixels = 0;
  int64_t cycles = 0;             // from the acceptance of the frame until the unit is empty
  Counters counters;              // as the hardware counted them
  std::optional<SpanSeed> probe;  // the seed asked for, as the hardware had it
  bool finished = false;
  std::string failure;  // why not, when the unit stopped responding
};

// The Verilated shading unit, driven by a plain loop.
class RtlShadingUnit {
 public:
  // The smallest build that contains the method; lanes: 1 or 4.
  static std::unique_ptr<RtlShadingUnit> Create(Method method, int lanes = 1);
  // The build with all methods.
  static std::unique_ptr<RtlShadingUnit> CreateAll(int lanes = 1);

  virtual ~RtlShadingUnit() = default;

  // Runs one frame to its end. `source` says when a new command may appear, `sink` when a pixel is
  // taken. Gives up when nothing moves for far longer than the patterns explain.
  virtual RtlResult Run(const FrameWork& work, const FlowPattern& source, const FlowPattern& sink,
                        PixelConsumer* consumer, const Observation& observation) = 0;
};

}  // namespace shading::tb
