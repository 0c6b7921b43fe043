// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/frame_work.h"
#include "model/shading_unit.h"
#include "sim/picture_error.h"
#include "tb/scoreboard/scoreboard.h"

namespace shading::sim {

// What a comparison of RTL and model counted.
struct Comparison {
  int64_t pixels_expected = 0, pixels_compared = 0, pixel_mismatches = 0;
  int64_t spans_expected = 0, spans_compared = 0, cycle_mismatches = 0;
  int64_t bad_frames = 0;  // frames that did not end, lost pixels, or counted other cycles

  bool Good() const {
    return pixels_compared == pixels_expected && pixel_mismatches == 0 &&
           spans_compared == spans_expected && cycle_mismatches == 0 && bad_frames == 0;
  }
  void Add(const tb::Verdicts& verdicts);
  void Add(const Comparison& other);
};

// The numbers of one run: a scene, or many random frames, by one method and engine.
struct RunStats {
  std::string scene, method, engine;
  int width = 0, height = 0;
  int64_t triangles = 0;  // packets
  int64_t spans = 0, cycles = 0;
  int64_t split_spans = 0;  // spans in two: their normals are over 90 degrees apart
  int64_t over_limit = 0;   // triangles whose normals turn too far for the tolerance
  int64_t pieces = 0;       // what they were split into
  int lanes = 1;            // pixels per cycle
  Counters counters;
  std::array<MethodShare, kMethodCount> share;  // auto: what each method shaded
  SkipCounts skipped;
  double sim_seconds = 0;
  std::optional<Comparison> comparison;
  std::optional<PictureError> phong_error, closed_form_error;

  double PixelCycles() const;      // cycles per pixel
  double PixelsPerSecond() const;  // of the simulation
  void AddWork(const FrameWork& work, int64_t packets);
  void Add(const RunStats& other);  // sums; errors become the worst, scene and method stay
};

// The keys that other programs read, for all runs together at the top and one by one in "runs";
// the command that made them, version and machine. Several runs have method "all" where methods
// differ, and the size only where it is the same.
void WriteJson(const std::string& path, const std::string& command,
               const std::vector<RunStats>& runs);

// Says on stderr which run covers no pixel, if any does.
bool ReportEmpty(const std::vector<RunStats>& runs);

// A few lines of text for a person.
std::string Summary(const RunStats& run);

}  // namespace shading::sim
