// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/face.h"

#include <cmath>

#include "sim/bench/pareto.h"

namespace shading::sim {
namespace {
constexpr double kErrorStep = 0.01;  // LSB; smaller differences are those of single roundings
constexpr double kCostRatio =
    1.01;  // smaller ones: a few cycles of latency a frame, noise of times

double CostStep(double cost) {
  return cost > 0 ? std::round(std::log(cost) / std::log(kCostRatio)) : cost;
}
}  // namespace

const std::vector<Face> kFaces = {
    {"RTL, 1 lane", "RTL cycles per pixel", "Clock cycles of the RTL with one lane.",
     Face::Kind::kCycles, 1},
    {"RTL, 4 lanes", "RTL cycles per pixel", "Clock cycles of the RTL with four lanes.",
     Face::Kind::kCycles, 4},
    {"RTL cycles x area", "cycles x cells per pixel",
     "What the same silicon shades in the same time: cycles per pixel times the cells of the whole "
     "shading unit, one lane (circles) and four (squares) against each other.",
     Face::Kind::kCyclesTimesArea, 0},
    {"Sequential processor", "cycles per pixel",
     "The papers' cost model: a product 8 cycles, an addition, a shift or a look-up 1, for all "
     "that triangles, spans and pixels of this scene need.",
     Face::Kind::kProcessor, 1},
    {"Software", "ns per pixel",
     "Processor time of the bit-exact model and its front end, one thread, the least of some runs.",
     Face::Kind::kSoftware, 1},
};

std::optional<double> Face::Cost(const Cell& cell, const Results& results) const {
  switch (kind) {
    case Kind::kCycles: return cell.CyclesPerPixel();
    case Kind::kProcessor: return cell.PaperCyclesPerPixel();
    case Kind::kSoftware: return cell.SoftwareNanoseconds();
    case Kind::kCyclesTimesArea: break;
  }
  if (!results.synthesis) return std::nullopt;
  const auto area = results.synthesis->Area(cell.key.method, cell.key.lanes);
  if (!area) return std::nullopt;
  return *area * cell.CyclesPerPixel();
}

double ErrorOf(const Cell& cell, ErrorKind kind) {
  return kind == ErrorKind::kRms ? cell.phong.rms_lsb : cell.phong.max_lsb;
}

Contest Compare(const Results& results, const Face& face, const std::string& scene, int shininess,
                ErrorKind kind) {
  Contest contest;
  std::vector<CostError> points;
  for (const Cell& cell : results.cells) {
    if (cell.key.scene != scene || cell.key.shininess != shininess) continue;
    if (face.lanes != 0 && cell.key.lanes != face.lanes) continue;
    const std::optional<double> cost = face.Cost(cell, results);
    if (!cost) continue;
    const double error = ErrorOf(cell, kind);
    points.push_back({CostStep(*cost), std::round(error / kErrorStep)});
    contest.entrants.push_back({&cell, *cost, error});
  }
  for (const size_t i : ParetoFront(points)) contest.entrants[i].front = true;
  return contest;
}

}  // namespace shading::sim
