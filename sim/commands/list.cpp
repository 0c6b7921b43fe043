// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "model/contracts.h"
#include "sim/commands/commands.h"
#include "sim/io/atomic_file.h"
#include "sim/scene/builtin.h"

namespace shading::sim {
namespace {

constexpr std::array kMethodText = {
    "one colour per triangle: light of the mean of its normals",
    "linear interpolation of the vertices' intensities",
    "second-order surface through six nodes, paper 003 (5): I(x+2) = 2 I(x+1) - I(x) + 2A",
    "the same surface by paper 003 (2): 8 products per pixel",
    "the same surface by paper 003 (9): 5 products per pixel",
    "the same surface by paper 003 (3): I(x+1) = I + 2Ax + A + Cy + D",
    "the same surface by paper 003 (6): every second pixel from its neighbours",
    "the same surface by paper 003 (7): I(x+3) = I(x+2) + I(x+1) - I + 4A",
    "the same surface by paper 003 (8), figure 5: I(x+3) = 3 (I(x+2) - I(x+1)) + I",
    "the ends of 2^k-pixel segments by paper 003, linear within --tolerance between them",
    "the same surface by two registers: I += d, d += 2A",
    "quad with the mean over a pixel's footprint, paper 001: a constant of the triangle",
    "second-order surfaces of unclamped diffuse and of specular light, clamped and added per pixel",
    "second-order surfaces of unclamped N.L and N.H, clamp and power per pixel",
    "phong-duff from surfaces of the triangle: set up in a cycle; normals up to 104 degrees apart",
    "linear normal, normalised and lit at every pixel",
    "linear normal, normalised by three terms of Taylor's series",
    "linear N.L and N.H over the root of a quadratic |N|^2 (Duff): phong without vectors",
    "spherical normal, paper 000 (7) as a scaled difference recurrence, lit at every pixel",
    "spherical normal, paper 000 (7); (9) to (11), corrected, with four lanes",
    "spherical N.L and N.H, paper 000 (14), as slerp: no vectors per pixel",
    "spherical normal, paper 000 (6): sine and cosine of every pixel by a CORDIC",
    "slerp's normals where it shows: bisection within --tolerance, lines between; paper 002",
    "the same as printed: of the span extended to 2^k steps; misses its end",
    "Phong's normals where it shows: normalised points of the chord, lines between",
    "mean light of 1 to 8 samples of a pixel's ellipse, as the turn of the normal wants; paper 001",
    "the same in the paper's enlarged triangle: samples outside it are excluded",
    "each triangle by the cheapest method that is sure to stay within --tolerance of phong"};
static_assert(kMethodText.size() == kMethodCount);

// A bound is in ulp of the output, unless what it is valid for says codes.
struct Bound {
  const char* unit;
  std::string_view valid_for;
};
Bound BoundOf(const UnitContract& contract) {
  const std::string_view valid_for = contract.valid_for;
  for (const std::string_view start : {"in codes, ", "codes "}) {
    if (valid_for.substr(0, start.size()) == start) {
      return {"codes", valid_for.substr(start.size())};
    }
  }
  return {"ulp", valid_for};
}

void PrintTables() {
  fmt::print("Methods\n");
  for (const Method method : kAllMethods) {
    fmt::print("  {:22} {}\n", Name(method), kMethodText[static_cast<size_t>(method)]);
  }
  fmt::print(
      "\nUnits: latency and initiation interval in cycles (0 and 0: front end, C++ only), "
      "error bound and where it holds\n");
  for (const UnitContract& unit : kContracts) {
    fmt::print("  {:22} {:9} latency {} interval {} in: {}; out: {}\n", unit.name, unit.group,
               unit.latency_cycles, unit.interval_cycles, unit.input, unit.output);
    const Bound bound = BoundOf(unit);
    fmt::print("  {:22} {:9} error <= {:.8g} {}, {}\n", "", "", unit.max_error_ulp, bound.unit,
               bound.valid_for);
  }
  fmt::print("\nBuilt-in scenes: builtin:NAME or builtin:NAME:N\n");
  for (const BuiltinScene& scene : kBuiltinScenes) {
    fmt::print("  {:8} N = {:<3} {}\n", scene.name, scene.default_n, scene.description);
  }
}

void WriteTables(const std::string& path) {
  nlohmann::ordered_json json;
  for (const Method method : kAllMethods) {
    json["methods"].push_back(
        {{"name", Name(method)}, {"description", kMethodText[static_cast<size_t>(method)]}});
  }
  for (const UnitContract& unit : kContracts) {
    json["units"].push_back({{"name", unit.name},
                             {"group", unit.group},
                             {"latency_cycles", unit.latency_cycles},
                             {"interval_cycles", unit.interval_cycles},
                             {"input", unit.input},
                             {"output", unit.output},
                             {"max_error_ulp", unit.max_error_ulp},
                             {"error_unit", BoundOf(unit).unit},
                             {"valid_for", unit.valid_for}});
  }
  for (const BuiltinScene& scene : kBuiltinScenes) {
    json["scenes"].push_back(
        {{"name", scene.name}, {"description", scene.description}, {"default_n", scene.default_n}});
  }
  AtomicFile file(path);
  file.stream() << json.dump(2) << '\n';
  file.Commit();
}

}  // namespace

int List(const Options& options) {
  if (!options.json.empty()) {
    WriteTables(options.json);
  } else if (!options.quiet) {
    PrintTables();
  }
  return 0;
}

}  // namespace shading::sim
