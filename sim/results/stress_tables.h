// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sim/report/table.h"
#include "sim/results/run_folder.h"

namespace shading::sim {

// Tables from stress.json. A file without what they need throws std::exception.

// Worst cases found against the bounds; `narrow`: the same with a bit less in every unit.
report::Table BoundTable(const Json& stress, const Json& narrow);
report::Table TroubleTable(const Json& stress);
// A row a number of fraction bits, a column a form: to nearest / truncated.
report::Table WordTable(const Json& stress);
// Units that are not searched, and why, in a sentence each reason.
std::string NotSearched(const Json& stress);
// How many bounds and conditions are broken, and that a bit less breaks every bound.
std::string BrokenWords(const Json& stress, const Json& narrow);

}  // namespace shading::sim
