// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace shading::tb {

// Changes of single bits in a waveform (.fst). Clock, reset and input ports do not count: an input
// of a unit is an output of another. Names of one net count once.
struct SignalToggles {
  std::string path;  // scopes and name, with dots
  std::string unit;  // the innermost instance u_NAME around it, or "top"
  int64_t bits = 0;
  int64_t toggles = 0;  // changes of them
};
// Throws std::runtime_error when the file cannot be read.
std::vector<SignalToggles> CountToggles(const std::string& fst);

// Their sums.
struct UnitToggles {
  int64_t bits = 0, toggles = 0;
};
using Toggles = std::map<std::string, UnitToggles>;
Toggles ByUnit(const std::vector<SignalToggles>& signals);

}  // namespace shading::tb
