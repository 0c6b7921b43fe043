// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "model/flow_pattern.h"

namespace shading {

// When one side of a stream is willing: every unit is tested under all of them, on every port.
enum class Flow { kAlways, kOneInFour, kRandom };

inline FlowPattern PatternOf(Flow flow, uint32_t seed) {
  switch (flow) {
    case Flow::kAlways: return FlowPattern::Always();
    case Flow::kOneInFour: return FlowPattern::OneInFour();
    case Flow::kRandom: break;
  }
  return FlowPattern::Random(seed);
}

inline std::string NameOf(Flow flow) {
  switch (flow) {
    case Flow::kAlways: return "Always";
    case Flow::kOneInFour: return "OneInFour";
    case Flow::kRandom: break;
  }
  return "Random";
}

}  // namespace shading
