// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/bench/face.h"
#include "sim/report/table.h"

namespace shading::sim {

// Tables of a run, for the report and docs/results.md.

// Methods on the fronts: a row a face, a column each n; in how many scenes.
report::Table FrontTable(const Results& results, ErrorKind kind);
// Cycles per span of some lengths, with one lane and four.
report::Table SpanTable(const Results& results);
// A scene at an n: cycles, and where they went.
report::Table CycleTable(const Results& results, const std::string& scene, int shininess);
// A scene at an n: errors and time in software.
report::Table ErrorTable(const Results& results, const std::string& scene, int shininess);
// Operations of each method, part by part.
report::Table OperationTable(const Results& results);
report::Table UnitTable(const Synthesis& synthesis);
report::Table AreaTable(const Results& results, const Synthesis& synthesis);
// Every cell.
report::Table CellTable(const Results& results);

}  // namespace shading::sim
