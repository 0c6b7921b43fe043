// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/flow_pattern.h"
#include "model/raster/front_end.h"
#include "model/shading_types.h"
#include "sim/scene/camera.h"

namespace shading::sim {

enum class Command { kRender, kVerify, kCycles, kBench, kStress, kList };
enum class Engine { kModel, kRtl, kIdeal };

struct Options {
  Command command = Command::kList;
  std::vector<std::string> scenes;
  std::vector<Method> methods;
  Engine engine = Engine::kRtl;
  int lanes = 1;                            // pixels per cycle
  int fraction_bits = Quantity::kFraction;  // of slerp-paper
  FrontEndOptions front_end;                // tolerance, subdivision
  ViewOptions view;
  bool view_given = false;  // an option that a packet file decides by itself
  std::string backpressure = "none";
  bool backpressure_given = false;
  uint32_t seed = 1;
  int64_t random = 0;  // triangles of verify --random
  int jobs = 1;
  bool quiet = false;
  std::string narrow, replay;  // of stress
  std::string image, error_map, trace, json, csv, triangles_out;
  std::string out, markdown;                   // of bench
  std::string synthesis = "build/synth.json";  // what scripts/synth.sh wrote
  bool synthesis_given = false;                // then it must be there
  bool quick = false, fresh = false;
  std::string command_line;  // as given, for reports

  bool OneMethod() const { return methods.size() == 1; }
  // In which cycles pixels are taken.
  FlowPattern Sink() const;
};

// nullopt when the command line asked for help or the version, which are then printed. Throws
// CLI::Error for what it cannot mean.
std::optional<Options> ParseOptions(int argc, char** argv);

}  // namespace shading::sim
