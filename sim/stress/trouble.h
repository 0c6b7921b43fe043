// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace shading::stress {

// What must hold in a scene that is hard on the arithmetic.
struct Condition {
  std::string family;   // coverage, triangles, drift, traps
  std::string scene;    // what is drawn
  std::string measure;  // what is counted or measured, and its unit
  int64_t cases = 0;
  double worst = 0, limit = 0;
  double naive = -1;  // what an obvious shortcut would give; below 0: none
  bool Broken() const { return !(worst <= limit); }
};
using Scene = std::function<Condition(bool quick, uint32_t seed)>;

std::vector<Scene> CoverageScenes();  // every pixel of neighbours exactly once
std::vector<Scene> TriangleScenes();  // slivers, needles, far and near vertices, opposed normals
std::vector<Scene> DriftScenes();     // rows, then columns, of 4096 pixels; spans of every length
std::vector<Scene> TrapScenes();      // clamps, overshoot, registers that wrap
std::vector<Scene> AllScenes();

}  // namespace shading::stress
