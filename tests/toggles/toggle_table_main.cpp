// SPDX-License-Identifier: Apache-2.0
//
// Prints the toggles of docs/auto.md: toggle_table [SCENE].
#include <fmt/format.h>

#include <array>
#include <exception>
#include <map>
#include <string>

#include "model/raster/front_end.h"
#include "sim/scene/builtin.h"
#include "sim/scene/camera.h"
#include "sim/scene/import.h"
#include "tests/toggles/toggle_run.h"

namespace shading::test {
namespace {

constexpr std::array<Method, 8> kMethods = {
    Method::kFlat,  Method::kGouraud,        Method::kQuad,     Method::kQuadCosine,
    Method::kPhong, Method::kSlerpIntensity, Method::kPhongDuff, Method::kAuto};

void Print(const std::string& scene) {
  sim::ViewOptions view;
  view.width = view.height = 96;
  const TriangleList list = sim::Project(
      scene.rfind("builtin:", 0) == 0 ? sim::MakeBuiltin(scene) : sim::ImportMesh(scene), view);
  const double pixels =
      static_cast<double>(FrontEnd::Run(list, Method::kFlat, {}).pixels);
  std::map<std::string, std::map<Method, int64_t>> units;
  std::map<Method, int64_t> sums;
  for (const Method method : kMethods) {
    for (const auto& [unit, count] :
         TogglesOf(list, method, Tolerance::FromRaw(int64_t{1} << Tolerance::kFraction))) {
      units[unit][method] = count.toggles;
      sums[method] += count.toggles;
    }
  }
  fmt::print("{}, {} x {}, tolerance 1 LSB: changes of bits a pixel\n\n| unit |", scene, view.width,
             view.height);
  for (const Method method : kMethods) fmt::print(" {} |", Name(method));
  fmt::print("\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  const auto row = [&](const std::string& name, const std::map<Method, int64_t>& counts) {
    fmt::print("| {} |", name);
    for (const Method method : kMethods) {
      const auto found = counts.find(method);
      const int64_t count = found == counts.end() ? 0 : found->second;
      const double each = static_cast<double>(count) / pixels;
      fmt::print(" {} |", count == 0 ? "0" : fmt::format("{:.3g}", each));
    }
    fmt::print("\n");
  };
  for (const auto& [name, counts] : units) row(name, counts);
  row("all", sums);
}

}  // namespace
}  // namespace shading::test

int main(int argc, char** argv) {
  try {
    shading::test::Print(argc > 1 ? argv[1] : "builtin:sphere:12");
  } catch (const std::exception& error) {
    fmt::print(stderr, "toggle_table: {}\n", error.what());
    return 1;
  }
  return 0;
}
