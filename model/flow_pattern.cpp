// SPDX-License-Identifier: Apache-2.0
#include "model/flow_pattern.h"

#include <algorithm>
#include <random>
#include <stdexcept>

namespace shading {

FlowPattern::FlowPattern(std::vector<uint8_t> bits) : bits_(std::move(bits)) {
  for (size_t cycle = 0; cycle < bits_.size(); ++cycle) {
    rank_.push_back(count());
    if (bits_[cycle]) willing_.push_back(static_cast<int64_t>(cycle));
  }
  if (willing_.empty()) {
    throw std::invalid_argument("flow pattern is never ready: it needs at least one 1");
  }
  for (int64_t rank = 0; rank < count(); ++rank) {
    longest_gap_ = std::max(longest_gap_, Select(rank + 1) - Select(rank) - 1);
  }
}

FlowPattern FlowPattern::Always() { return FlowPattern({1}); }

FlowPattern FlowPattern::OneInFour() { return FlowPattern({0, 0, 0, 1}); }

FlowPattern FlowPattern::Random(uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<uint8_t> bits(65536);
  for (uint8_t& bit : bits) bit = static_cast<uint8_t>(random() >> 31);
  return FlowPattern(std::move(bits));
}

FlowPattern FlowPattern::Recorded(std::string_view bits) {
  std::vector<uint8_t> values;
  for (const char c : bits) {
    if (c != '0' && c != '1') {
      throw std::invalid_argument("flow pattern may hold only 0 and 1");
    }
    values.push_back(static_cast<uint8_t>(c - '0'));
  }
  return FlowPattern(std::move(values));
}

}  // namespace shading
