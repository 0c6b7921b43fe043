// SPDX-License-Identifier: Apache-2.0
//
// Prints toggles and operations a pixel for docs/auto.md: toggle_table [SCENE [SIZE]].
#include <fmt/format.h>

#include <array>
#include <map>
#include <string>

#include "sim/bench/cost_model.h"
#include "sim/bench/measure.h"
#include "tests/toggles/toggle_run.h"
#include "tests/toggles/toggle_scene.h"

namespace shading::test {
namespace {

constexpr std::array<Method, 8> kMethods = {
    Method::kFlat,  Method::kGouraud,        Method::kQuad,      Method::kQuadCosine,
    Method::kPhong, Method::kPhongSurface, Method::kPhongDuff, Method::kAuto};

// Of one frame, by one method; a number a pixel.
struct Row {
  tb::Toggles units;
  double toggles = 0, operations = 0, cycles = 0;
  int64_t trace_bytes = 0;
};

Row Measure(const TriangleList& list, Method method) {
  const FrameWork work = WorkOf(list, method);
  const TracedFrame frame = Trace(work);
  const auto pixels = static_cast<double>(work.pixels);
  sim::Workload load;
  load.triangles = static_cast<int64_t>(work.triangles.size());
  load.spans = static_cast<int64_t>(work.spans.size());
  load.pixels = work.pixels;
  load.highlights = LightsPixels(method) ? work.pixels - frame.counters.no_highlight : 0;
  load.share = work.share;
  return {tb::ByUnit(frame.signals), static_cast<double>(frame.toggles()) / pixels,
          sim::PaperCycles(sim::TotalOf(method, load)) / pixels,
          static_cast<double>(frame.cycles) / pixels, frame.trace_bytes};
}

using Rows = std::map<Method, Row>;

void PrintUnits(const Rows& rows, double pixels) {
  std::map<std::string, std::map<Method, int64_t>> units;
  for (const auto& [method, row] : rows) {
    for (const auto& [unit, count] : row.units) units[unit][method] = count.toggles;
  }
  fmt::print("| unit |");
  for (const Method method : kMethods) fmt::print(" {} |", Name(method));
  fmt::print("\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (auto& [unit, counts] : units) {
    fmt::print("| {} |", unit);
    for (const Method method : kMethods) {
      fmt::print(" {:.3g} |", static_cast<double>(counts[method]) / pixels);
    }
    fmt::print("\n");
  }
  const auto sums = [&](const char* name, double Row::*number) {
    fmt::print("| {} |", name);
    for (const Method method : kMethods) fmt::print(" {:.3g} |", rows.at(method).*number);
    fmt::print("\n");
  };
  sums("all", &Row::toggles);
  sums("weighted operations", &Row::operations);
  sums("cycles", &Row::cycles);
}

// What auto has of another method's numbers.
void PrintGain(const Rows& rows, Method other) {
  const auto change = [&](double Row::*number) {
    return 100 * (rows.at(Method::kAuto).*number / rows.at(other).*number - 1);
  };
  fmt::print("| {} | {:+.1f} % | {:+.1f} % | {:+.1f} % |\n", Name(other), change(&Row::toggles),
             change(&Row::operations), change(&Row::cycles));
}

void Print(const std::string& scene, const TriangleList& list) {
  Rows rows;
  for (const Method method : kMethods) rows[method] = Measure(list, method);
  const FrameWork work = WorkOf(list, Method::kAuto);
  fmt::print("{}, {} x {}, tolerance 1 LSB: changes of bits a pixel, {} pixels\n\n", scene,
             list.frame.width, list.frame.height, work.pixels);
  PrintUnits(rows, static_cast<double>(work.pixels));
  fmt::print("\n| auto against | toggles | weighted operations | cycles |\n|---|--:|--:|--:|\n");
  PrintGain(rows, Method::kPhong);
  const uint32_t sure = sim::SureMethods(work);
  Method best = Method::kPhong;
  for (const Method method : kMethods) {
    const bool is_sure = (sure >> static_cast<unsigned>(method) & 1) != 0;
    if (method == Method::kAuto || !is_sure) continue;
    if (rows[method].toggles < rows[best].toggles) best = method;
  }
  PrintGain(rows, best);
  fmt::print("\n{} is the best single method that is sure; waveform of auto {} KB\n", Name(best),
             rows[Method::kAuto].trace_bytes / 1024);
}

}  // namespace
}  // namespace shading::test

int main(int argc, char** argv) {
  return shading::test::PrintScene("toggle_table", argc, argv, shading::test::Print);
}
