// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/bench_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "sim/report/html.h"

namespace shading::sim {
namespace {

using report::Entry;
using report::Significant;
using report::Table;

// "a, b in all 5 scenes; c in 2 of 5".
std::string FrontWords(const Results& results, const Face& face, int n, ErrorKind kind) {
  std::vector<std::string> order;
  std::map<std::string, int> scenes;
  for (const std::string& scene : results.scenes) {
    for (const Contest::Entrant& e : Compare(results, face, scene, n, kind).entrants) {
      if (!e.front) continue;
      std::string name = Label(e.cell->key);
      if (face.lanes == 0 && e.cell->key.lanes > 1) name += " x4";
      if (scenes[name]++ == 0) order.push_back(name);
    }
  }
  const int all = static_cast<int>(results.scenes.size());
  std::string words;
  for (int count = all; count > 0; --count) {
    std::string names;
    for (const std::string& name : order) {
      if (scenes[name] == count) names += (names.empty() ? "" : ", ") + name;
    }
    if (names.empty()) continue;
    words += (words.empty() ? "" : "; ") + names;
    if (all > 1)
      words +=
          count == all ? fmt::format(" in all {}", all) : fmt::format(" in {} of {}", count, all);
  }
  return words.empty() ? "not known" : words;
}

std::string Parts(const Operations& o) {
  if (o.total() == 0) return "0";
  return fmt::format("{:.4g} x, {:.4g} +, {:.4g} sh{}", o.multiplications, o.additions, o.shifts,
                     o.look_ups > 0 ? fmt::format(", {:.4g} tab", o.look_ups) : "");
}

}  // namespace

Table FrontTable(const Results& results, ErrorKind kind) {
  std::vector<std::string> headings = {"run time as"};
  for (const int n : results.shininess) headings.push_back(fmt::format("n = {}", n));
  Table table(headings);
  for (const Face& face : kFaces) {
    std::vector<Entry> row = {face.name};
    for (const int n : results.shininess) row.push_back(FrontWords(results, face, n, kind));
    table.Add(row);
  }
  return table;
}

Table SpanTable(const Results& results) {
  constexpr std::array<int, 5> kLengths = {1, 4, 16, 64, 256};
  std::vector<std::string> headings = {"method", "latency, cycles"};
  for (const int lanes : {1, 4}) {
    for (const int length : kLengths) {
      headings.push_back(fmt::format("{} pixel{}, {} lane{}", length, length > 1 ? "s" : "", lanes,
                                     lanes > 1 ? "s" : ""));
    }
  }
  Table table(headings);
  for (const Method method : results.methods) {
    const SpanCurve *one = results.Curve(method, 1), *four = results.Curve(method, 4);
    if (one == nullptr || four == nullptr) continue;
    std::vector<Entry> row = {std::string(Name(method)), Entry::Count(one->latency)};
    for (const SpanCurve* curve : {one, four}) {
      for (const int length : kLengths) row.emplace_back(curve->CyclesOf(length));
    }
    table.Add(row);
  }
  return table;
}

Table CycleTable(const Results& results, const std::string& scene, int shininess) {
  Table table({"method", "lanes", "cycles", "per pixel", "per span", "set-up, per span",
               "fill, per frame", "stall, per span", "RTL simulation, ns per pixel"});
  for (const Cell& c : results.cells) {
    if (c.key.scene != scene || c.key.shininess != shininess) continue;
    table.Add({Label(c.key), Entry::Count(c.key.lanes), Entry::Count(c.cycles), c.CyclesPerPixel(),
               c.PerSpan(static_cast<double>(c.cycles)), c.PerSpan(static_cast<double>(c.setup)),
               Entry::Count(c.fill), c.PerSpan(static_cast<double>(c.stall)),
               c.PerPixel(1e9 * c.rtl_seconds)});
  }
  return table;
}

Table ErrorTable(const Results& results, const std::string& scene, int shininess) {
  Table table({"method", "max, LSB", "RMS, LSB", "PSNR, dB", "against its closed form: max, LSB",
               "RMS, LSB", "papers' cycles per pixel", "model, ns per pixel",
               "front end, ns per pixel"});
  for (const Cell& c : results.cells) {
    if (c.key.scene != scene || c.key.shininess != shininess || c.key.lanes != 1) continue;
    table.Add({Label(c.key), c.phong.max_lsb, c.phong.rms_lsb, c.phong.psnr_db,
               c.closed_form.max_lsb, c.closed_form.rms_lsb, c.PaperCyclesPerPixel(),
               c.PerPixel(1e9 * c.model_seconds), c.PerPixel(1e9 * c.front_end_seconds)});
  }
  return table;
}

Table OperationTable(const Results& results) {
  Table table({"method", "triangle", "span", "pixel", "pixel with highlight, more",
               "cycles a pixel", "cycles a span", "cycles a triangle", "counted from"});
  for (const Method method : results.methods) {
    const MethodCost cost = CostOf(method);
    if (method == Method::kAuto) {
      table.Add({std::string(Name(method)), Parts(cost.triangle) + ", and its methods'",
                 "its methods'", "its methods'", "its methods'", "its methods'", "its methods'",
                 PaperCycles(cost.triangle), cost.reason});
      continue;
    }
    table.Add({std::string(Name(method)), Parts(cost.triangle), Parts(cost.span), Parts(cost.pixel),
               Parts(cost.highlight), PaperCycles(cost.pixel), PaperCycles(cost.span),
               PaperCycles(cost.triangle), cost.reason});
  }
  return table;
}

Table UnitTable(const Synthesis& synthesis) {
  Table table({"unit", "LUT4", "flip-flops", "carry cells", "18x18 multipliers", "cells",
               "longest path, LUT4 levels"});
  for (const Synthesis::Unit& unit : synthesis.units) {
    const CellCount& c = unit.cells;
    table.Add({unit.name, Entry::Count(c.lut4), Entry::Count(c.flip_flops), Entry::Count(c.carry),
               Entry::Count(c.multipliers),
               Entry(synthesis.Area(c), fmt::format("{:.0f}", synthesis.Area(c))),
               c.path > 0 ? Entry::Count(c.path) : Entry("not measured")});
  }
  return table;
}

Table AreaTable(const Results& results, const Synthesis& synthesis) {
  Table table(
      {"method", "lanes", "LUT4", "flip-flops", "carry cells", "18x18 multipliers", "cells"});
  for (const Synthesis::Build& build : synthesis.builds) {
    if (!results.Has(build.method)) continue;
    const CellCount& c = build.cells;
    table.Add({std::string(Name(build.method)), Entry::Count(build.lanes), Entry::Count(c.lut4),
               Entry::Count(c.flip_flops), Entry::Count(c.carry), Entry::Count(c.multipliers),
               Entry(synthesis.Area(c), fmt::format("{:.0f}", synthesis.Area(c)))});
  }
  return table;
}

Table CellTable(const Results& results) {
  Table table({"scene", "method", "n", "lanes", "cycles per pixel", "operations per pixel",
               "papers' cycles per pixel", "model + front end, ns per pixel",
               "RTL simulation, ns per pixel", "max, LSB", "RMS, LSB", "PSNR, dB",
               "closed form: max, LSB", "RMS, LSB"});
  for (const Cell& c : results.cells) {
    table.Add({c.key.scene, Label(c.key), Entry::Count(c.key.shininess), Entry::Count(c.key.lanes),
               c.CyclesPerPixel(), c.OperationsPerPixel().total(), c.PaperCyclesPerPixel(),
               c.SoftwareNanoseconds(), c.PerPixel(1e9 * c.rtl_seconds), c.phong.max_lsb,
               c.phong.rms_lsb, c.phong.psnr_db, c.closed_form.max_lsb, c.closed_form.rms_lsb});
  }
  return table;
}

}  // namespace shading::sim
