// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/synthesis.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sim/bench/bench_cell.h"

namespace shading::sim {
namespace {

using Json = nlohmann::json;

CellCount Count(const Json& json) {
  CellCount cells;
  cells.lut4 = json.at("lut4");
  cells.flip_flops = json.at("flip_flops");
  cells.carry = json.at("carry");
  cells.multipliers = json.at("multipliers");
  cells.path = json.value("path_lut4", int64_t{0});
  return cells;
}

bool IsMethod(const std::string& name) {
  for (const Method method : kAllMethods) {
    if (name == Name(method)) return true;
  }
  return false;
}

Synthesis Parse(const Json& json) {
  if (json.at("format") != "shadesim-synthesis" || json.at("version") != 1) {
    throw std::invalid_argument("format is not shadesim-synthesis, version 1");
  }
  Synthesis synthesis;
  synthesis.tool = json.at("tool");
  synthesis.target = json.at("target");
  synthesis.multiplier_lut4 = json.at("multiplier_lut4");
  for (const Json& unit : json.at("units")) {
    synthesis.units.push_back({unit.at("name"), Count(unit)});
  }
  for (const Json& build : json.at("builds")) {
    const std::string name = build.at("method");
    if (!IsMethod(name)) continue;
    synthesis.builds.push_back({MethodOf(name), build.at("lanes"), Count(build)});
  }
  return synthesis;
}

}  // namespace

const Synthesis::Unit* Synthesis::FindUnit(const std::string& name) const {
  for (const Unit& unit : units) {
    if (unit.name == name) return &unit;
  }
  return nullptr;
}

double Synthesis::Area(const CellCount& cells) const {
  return static_cast<double>(cells.lut4 + cells.flip_flops + 2 * cells.carry +
                             multiplier_lut4 * cells.multipliers);
}

std::optional<double> Synthesis::Area(Method method, int lanes) const {
  for (const Build& build : builds) {
    if (build.method == method && build.lanes == lanes) return Area(build.cells);
  }
  return std::nullopt;
}

std::optional<Synthesis> ReadSynthesis(const std::string& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(
        fmt::format("{}: is a folder; give the file that scripts/synth.sh --json wrote", path));
  }
  std::ifstream file(path);
  try {
    return Parse(Json::parse(file));
  } catch (const Json::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{0}: not JSON at byte {1}; write it again by scripts/synth.sh --json {0}",
                    path, error.byte));
  } catch (const std::exception& error) {
    std::string reason = error.what();
    for (char& c : reason) c = c == '\n' ? ' ' : c;
    throw std::runtime_error(
        fmt::format("{}: not a result of scripts/synth.sh --json ({})", path, reason));
  }
}

}  // namespace shading::sim
