// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "sim/bench/bench_cell.h"
#include "sim/bench/synthesis.h"

namespace shading::sim {

// A whole run, and the conditions that its numbers hold under.
struct Results {
  std::string command;  // that makes it again
  std::string machine, version;
  int width = 0, height = 0;
  std::vector<std::string> scenes;
  std::vector<Method> methods;
  std::vector<int> shininess;
  std::vector<Cell> cells;
  std::vector<SpanCurve> curves;
  std::optional<Synthesis> synthesis;
  std::string synthesis_note;  // why there is none

  bool Has(Method method) const;
  const SpanCurve* Curve(Method method, int lanes) const;
};

using CellNumber = std::function<double(const Cell&)>;
using CellTest = std::function<bool(const Cell&)>;

// Geometric mean over scenes and n of quantity(a) / quantity(b), one lane, least tolerance, of the
// cells of `a` that pass the test; none when the run has not both methods.
std::optional<double> MeanRatio(
    const Results& results, Method a, Method b, const CellNumber& of,
    const CellTest& test = [](const Cell&) { return true; });

// The largest of a quantity over the method's cells.
std::optional<double> Largest(const Results& results, Method method, const CellNumber& of);

// The method, and its tolerance where it has one.
std::string Label(const CellKey& key);

}  // namespace shading::sim
