// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/frame_work.h"
#include "model/shading_unit.h"
#include "tb/rtl_shading_unit.h"

namespace shading::tb {

// One pixel in which RTL and model differ.
struct Mismatch {
  int64_t triangle = 0;  // index in the frame's triangle list
  int64_t span = 0;      // index in the frame
  int index = 0;         // pixel of the span
  TimedPixel expected, actual;
  bool unexpected = false;  // the model has no such pixel
  SpanCommand command;
  Surface surface[kChannels];
  SpanSeed seed;  // the model's operands
};

// What a comparison saw. Good() demands that everything expected was compared.
struct Verdicts {
  int64_t pixels_expected = 0;
  int64_t pixels_compared = 0;
  int64_t pixel_mismatches = 0;
  int64_t spans_expected = 0;
  int64_t spans_compared = 0;    // all their pixels were compared
  int64_t cycle_mismatches = 0;  // spans with a pixel in another cycle than the model says
  bool counters_match = false;
  std::string failure;               // why the simulation ended early
  std::vector<Mismatch> mismatches;  // the first 20

  bool Good() const {
    return failure.empty() && pixels_compared == pixels_expected && pixel_mismatches == 0 &&
           spans_compared == spans_expected && cycle_mismatches == 0 && counters_match;
  }
};

// One span as it went through.
struct SpanRecord {
  SpanTiming model;
  int64_t rtl_last_left = 0;
  int64_t normalised = 0, skipped = 0;  // normalisations, adaptive methods
};

// Compares every pixel that leaves the RTL with the model: position, depth, colour, order and
// cycle. The model runs beside the simulation, one span at a time.
class Scoreboard : public PixelConsumer {
 public:
  static constexpr size_t kKept = 20;

  Scoreboard(const FrameWork& work, int lanes, const FlowPattern& source, const FlowPattern& sink);

  bool Consume(const TimedPixel* pixels, size_t count) override;

  // Ends the comparison; also compares the hardware's counters.
  const Verdicts& Finish(const RtlResult& result);

  // Appends a record for each span from now on.
  void RecordSpans(std::vector<SpanRecord>* records) { records_ = records; }

 private:
  void NextSpan();
  void Keep(const TimedPixel& actual, bool unexpected);

  const FrameWork& work_;
  ShadingUnit model_;
  std::vector<Pixel> pixels_;  // of the current span
  SpanTiming timing_;
  Counters before_;  // of the spans before
  int index_ = 0;
  int length_ = 0;
  bool cycle_differs_ = false;
  size_t next_span_ = 0;
  size_t next_triangle_ = 0;
  bool triangle_open_ = false;
  std::vector<SpanRecord>* records_ = nullptr;
  Verdicts verdicts_;
};

}  // namespace shading::tb
