// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sim/stress/stress_results.h"

namespace shading::stress {

nlohmann::json StressJson(const StressResults& results);
std::string WorstLine(const Finding& finding, uint32_t seed);  // one line of JSON, for --replay
std::string StressPage(const StressResults& results);

}  // namespace shading::stress
