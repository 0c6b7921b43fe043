// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "sim/stress/search.h"
#include "sim/stress/trouble.h"

namespace shading::stress {
namespace {

// An operand that is kept within a part of its range.
struct Pin {
  size_t gene;
  double low, high;
};

// A unit's check with some of its operands pinned: its bound must hold there as well.
Scene Pinned(const std::string& unit, const std::string& scene, const std::vector<Pin>& pins) {
  return [=](bool quick, uint32_t seed) {
    const std::vector<Check> checks = TriangleChecks();
    Check check =
        *std::find_if(checks.begin(), checks.end(), [&](const Check& c) { return c.unit == unit; });
    check.starts.clear();
    check.error = [pins, error = check.error](const Genes& g, int narrow) {
      Genes pinned = g;
      for (const Pin& pin : pins) pinned[pin.gene] = Between(pin.low, pin.high, g[pin.gene]);
      return error(pinned, narrow);
    };
    const Worst worst = Search(check, (quick ? 300000 : 10000000) / check.cost, seed);
    return Condition{"triangles",       scene,       unit + ", " + check.ulp,
                     worst.evaluations, worst.error, check.bound};
  };
}

const Pin kBandOnly = {0, 0, 0.199}, kSliver = {0, 0.4, 0.599}, kSmall = {0, 0.6, 0.799},
          kWholeSliver = {0, 0.8, 1};

// Vertices in opposite corners of the guard band and near a third one.
const std::vector<Pin> kEdges = {kBandOnly,     {1, 0, 0.001}, {2, 0, 0.001}, {3, 0.999, 1},
                                 {4, 0, 0.001}, {5, 0, 1},     {6, 0.999, 1}};
// All vertices within `pixels` of the centre of one, on a screen of 4096 columns.
std::vector<Pin> Tiny(double pixels, double rows) {
  const double x = (100.5 + 2) / (4096 + 4), dx = pixels / 4100;
  const double y = (10.5 + 2) / (rows + 4), dy = pixels / (rows + 4);
  std::vector<Pin> pins = {kSmall, {1, x - dx, x + dx}, {2, y - dy, y + dy}};
  for (size_t i = 3; i < 7; ++i) pins.push_back({i, 0.5 - pixels / 128, 0.5 + pixels / 128});
  return pins;
}

Scene Opposed(bool beyond) {
  return [beyond](bool quick, uint32_t seed) {
    Condition c{"triangles",
                "a normal near the opposite of another, edges and rows up to 170 degrees",
                "span_normals, 2^-30"};
    if (beyond) {
      c.scene = "the same, edges or rows of 170..179.9999 degrees";
      c.measure = "span_normals, part of 1/2 + 2^-7 / |Nl + Nr| ulp";
    }
    const Check check = OpposedNormals(beyond);
    const Worst worst = Search(check, quick ? 1500 : 60000, seed);
    c.cases = worst.evaluations;
    c.worst = worst.error;
    c.limit = check.bound;
    return c;
  };
}

}  // namespace

std::vector<Scene> TriangleScenes() {
  std::vector<Scene> scenes;
  for (const std::string unit : {"triangle_setup", "surface_fit", "span_normals"}) {
    const auto add = [&](const std::string& scene, const std::vector<Pin>& pins) {
      scenes.push_back(Pinned(unit, scene, pins));
    };
    add("slivers: a vertex within 3/256 pixel of the line of two", {kSliver});
    add("needles: the same across the screen", {kWholeSliver});
    add("vertices at the edges of the guard band, +-8191 pixels", kEdges);
    const double rows = unit == "span_normals" ? 32 : 4096;
    add("triangles within 1/8 pixel of a centre", Tiny(0.125, rows));
    add("triangles within 1/128 pixel of a centre", Tiny(1.0 / 128, rows));
  }
  scenes.push_back(Opposed(false));
  scenes.push_back(Opposed(true));
  return scenes;
}

std::vector<Scene> AllScenes() {
  std::vector<Scene> all;
  for (const auto family : {CoverageScenes, TriangleScenes, DriftScenes, TrapScenes}) {
    for (Scene& scene : family()) all.push_back(std::move(scene));
  }
  return all;
}

}  // namespace shading::stress
