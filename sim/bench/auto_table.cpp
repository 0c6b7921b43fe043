// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/auto_table.h"

#include <fmt/format.h>

namespace shading::sim {
namespace {

using report::Entry;
using report::Table;

bool IsRival(const Cell& cell, const Cell& other) {
  const CellKey &a = cell.key, &b = other.key;
  return b.method != Method::kAuto && a.scene == b.scene && a.shininess == b.shininess &&
         a.lanes == b.lanes && other.phong.max_lsb <= a.tolerance + kBeyondTolerance;
}

const Cell* Phong(const Results& results, const Cell& cell) {
  for (const Cell& other : results.cells) {
    if (other.key.method == Method::kPhong && IsRival(cell, other)) return &other;
  }
  return nullptr;
}

Entry Percent(double part, double whole) {
  const double percent = 100 * (part / whole - 1);
  return Entry(percent, fmt::format("{:+.1f} %", percent));
}

}  // namespace

const Cell* BestSingle(const Results& results, const Cell& cell) {
  const Cell* best = nullptr;
  for (const Cell& other : results.cells) {
    if (IsRival(cell, other) && (best == nullptr || other.cycles < best->cycles)) best = &other;
  }
  return best;
}

Table AutoTable(const Results& results) {
  Table table({"scene", "n", "tolerance, LSB", "max error, LSB", "cycles", "best other within it",
               "its cycles", "auto against it", "phong's cycles", "auto against phong",
               "papers' cycles per pixel", "of the best", "of phong"});
  for (const Cell& cell : results.cells) {
    if (cell.key.method != Method::kAuto || cell.key.lanes != 1) continue;
    const Cell *best = BestSingle(results, cell), *phong = Phong(results, cell);
    if (best == nullptr || phong == nullptr) continue;
    const auto cycles = static_cast<double>(cell.cycles);
    table.Add({cell.key.scene, Entry::Count(cell.key.shininess), cell.key.tolerance,
               cell.phong.max_lsb, Entry::Count(cell.cycles), Label(best->key),
               Entry::Count(best->cycles), Percent(cycles, static_cast<double>(best->cycles)),
               Entry::Count(phong->cycles), Percent(cycles, static_cast<double>(phong->cycles)),
               cell.PaperCyclesPerPixel(), best->PaperCyclesPerPixel(),
               phong->PaperCyclesPerPixel()});
  }
  return table;
}

}  // namespace shading::sim
