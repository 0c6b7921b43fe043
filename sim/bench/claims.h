// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "sim/bench/results.h"
#include "sim/report/claim.h"

namespace shading::sim {

// What papers 000 to 003 say of speed, cost and accuracy, each with what this run measured of it,
// or the page that measures it. The one place for them.
std::vector<report::Claim> PaperClaims(const Results& results);

}  // namespace shading::sim
