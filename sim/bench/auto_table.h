// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/bench/results.h"
#include "sim/report/table.h"

namespace shading::sim {

// What the displayed codes may be off by beyond the tolerance: the arithmetic of the units and the
// rounding of the code, LSB.
inline constexpr double kBeyondTolerance = 0.42 + 0.5;

// The cell with the fewest cycles among those of other methods with the scene, n and lanes of
// `cell`: of those that are sure to stay within its tolerance before they shade, as auto is, or
// that are measured to have done so; null when none is.
enum class Judged { kBefore, kAfter };
const Cell* BestSingle(const Results& results, const Cell& cell, Judged judged);

// auto beside the best other methods of the same accuracy and beside phong, one lane: a row for
// each scene, n and tolerance.
report::Table AutoTable(const Results& results);

}  // namespace shading::sim
