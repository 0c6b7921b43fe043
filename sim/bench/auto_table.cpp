// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/auto_table.h"

#include <fmt/format.h>

namespace shading::sim {
namespace {

using report::Entry;
using report::Table;

bool IsRival(const Cell& cell, const Cell& other, Judged judged) {
  const CellKey &a = cell.key, &b = other.key;
  if (b.method == Method::kAuto || a.scene != b.scene || a.shininess != b.shininess ||
      a.lanes != b.lanes) {
    return false;
  }
  return judged == Judged::kBefore ? (cell.sure >> static_cast<unsigned>(b.method) & 1) != 0
                                   : other.phong.max_lsb <= a.tolerance + kBeyondTolerance;
}

const Cell* Phong(const Results& results, const Cell& cell) {
  for (const Cell& other : results.cells) {
    if (other.key.method == Method::kPhong && IsRival(cell, other, Judged::kBefore)) return &other;
  }
  return nullptr;
}

Entry Percent(double part, double whole) {
  const double percent = 100 * (part / whole - 1);
  return Entry(percent, fmt::format("{:+.1f} %", percent));
}

}  // namespace

const Cell* BestSingle(const Results& results, const Cell& cell, Judged judged) {
  const Cell* best = nullptr;
  for (const Cell& other : results.cells) {
    if (!IsRival(cell, other, judged)) continue;
    if (best == nullptr || other.cycles < best->cycles) best = &other;
  }
  return best;
}

Table AutoTable(const Results& results) {
  Table table({"scene", "n", "tolerance, LSB", "max error, LSB", "cycles",
               "best other that is sure", "auto against it", "best other in hindsight",
               "auto against it", "auto against phong", "papers' cycles per pixel",
               "of the best sure", "of phong"});
  for (const Cell& cell : results.cells) {
    if (cell.key.method != Method::kAuto || cell.key.lanes != 1) continue;
    const Cell* sure = BestSingle(results, cell, Judged::kBefore);
    const Cell* after = BestSingle(results, cell, Judged::kAfter);
    const Cell* phong = Phong(results, cell);
    if (sure == nullptr || after == nullptr || phong == nullptr) continue;
    const auto against = [&](const Cell* other) {
      return Percent(static_cast<double>(cell.cycles), static_cast<double>(other->cycles));
    };
    table.Add({cell.key.scene, Entry::Count(cell.key.shininess), cell.key.tolerance,
               cell.phong.max_lsb, Entry::Count(cell.cycles), Label(sure->key), against(sure),
               Label(after->key), against(after), against(phong), cell.PaperCyclesPerPixel(),
               sure->PaperCyclesPerPixel(), phong->PaperCyclesPerPixel()});
  }
  return table;
}

}  // namespace shading::sim
