// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sim/stress/stress_results.h"

namespace shading::stress {

// Inline SVG. Error over the length of a span, of the forms with `bits` fraction bits.
std::string GrowthPlot(const StressResults& results, const std::string& paper, int bits);
// Error of 2048 pixels over the word length, products or coefficients to nearest or truncated.
std::string WordPlot(const StressResults& results, const std::string& title, bool truncated);
// Decades of error from 1e-6 codes, pale, to 100, dark.
std::string HeatSvg(const HeatMapOf& map);

}  // namespace shading::stress
