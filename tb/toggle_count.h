// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace shading::tb {

// Changes of single bits in a waveform (.fst), by unit: the innermost instance u_NAME around a
// signal, or "top". Clock, reset and input ports do not count: an input of a unit is an output of
// another.
// Throws std::runtime_error when the file cannot be read.
struct UnitToggles {
  int64_t bits = 0;     // of its signals
  int64_t toggles = 0;  // changes of them
};
using Toggles = std::map<std::string, UnitToggles>;
Toggles CountToggles(const std::string& fst);

}  // namespace shading::tb
