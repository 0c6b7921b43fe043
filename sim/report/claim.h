// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sim/report/table.h"

namespace shading::report {

enum class Verdict { kHolds, kHoldsInPart, kFails, kOnPage, kNotMeasured };

// What a paper says and what came of it.
struct Claim {
  std::string source;    // paper and place
  std::string claim;     // in the paper's words, shortened
  std::string measured;  // here, with numbers and conditions
  Verdict verdict = Verdict::kNotMeasured;
  std::string page;  // of the project that has more; may be empty
};

const char* Name(Verdict verdict);
Table ClaimTable(const std::vector<Claim>& claims);

}  // namespace shading::report
