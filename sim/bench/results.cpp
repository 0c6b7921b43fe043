// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/results.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace shading::sim {
namespace {

// The method's cell of the same scene and n with one lane and the least tolerance.
const Cell* Partner(const Results& results, const Cell& cell, Method method) {
  const Cell* best = nullptr;
  for (const Cell& other : results.cells) {
    const CellKey& key = other.key;
    if (key.method != method || key.lanes != 1 || key.scene != cell.key.scene ||
        key.shininess != cell.key.shininess) {
      continue;
    }
    if (best == nullptr || key.tolerance < best->key.tolerance) best = &other;
  }
  return best;
}

}  // namespace

bool Results::Has(Method method) const {
  return std::find(methods.begin(), methods.end(), method) != methods.end();
}

const SpanCurve* Results::Curve(Method method, int lanes) const {
  for (const SpanCurve& curve : curves) {
    if (curve.method == method && curve.lanes == lanes) return &curve;
  }
  return nullptr;
}

std::optional<double> MeanRatio(const Results& results, Method a, Method b, const CellNumber& of,
                                const CellTest& test) {
  double sum = 0;
  int count = 0;
  for (const Cell& cell : results.cells) {
    if (cell.key.method != a || !test(cell) || Partner(results, cell, a) != &cell) continue;
    const Cell* other = Partner(results, cell, b);
    if (other == nullptr || of(cell) <= 0 || of(*other) <= 0) continue;
    sum += std::log(of(cell) / of(*other));
    ++count;
  }
  if (count == 0) return std::nullopt;
  return std::exp(sum / count);
}

std::optional<double> Largest(const Results& results, Method method, const CellNumber& of) {
  std::optional<double> largest;
  for (const Cell& cell : results.cells) {
    if (cell.key.method == method) largest = std::max(largest.value_or(of(cell)), of(cell));
  }
  return largest;
}

std::string Label(const CellKey& key) {
  return key.tolerance > 0 ? fmt::format("{} {:g}", Name(key.method), key.tolerance)
                           : std::string(Name(key.method));
}

}  // namespace shading::sim
