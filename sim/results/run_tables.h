// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/report/table.h"
#include "sim/results/run_folder.h"

namespace shading::sim {

// Tables from the files that shadesim verify, cycles and render --json and shading_unit_bench
// write. A file without what they need throws std::exception.

// A row a command: the command and its file.
report::Table VerifyTable(const std::vector<std::pair<std::string, Json>>& files);
// One lane and four of the same scene and methods.
report::Table FrameCycleTable(const Json& one, const Json& four);
// Normalisations and samples of the methods that count them.
report::Table WorkTable(const Json& cycles);
report::Table FrameErrorTable(const Json& render);
// M pixels per second, and the ratios that the checked model is judged by.
report::Table SpeedTable(const Json& benchmark);
// Which methods' models are at least `factor` times as fast as their RTL, in a sentence.
std::string SpeedWords(const Json& benchmark, double factor);

}  // namespace shading::sim
