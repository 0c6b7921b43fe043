// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace shading {

// In which cycles one side of a stream is willing to transfer: a periodic sequence of bits, bit 0
// in the cycle in which the frame is accepted. RTL test benches replay it cycle by cycle; the model
// asks for the n-th willing cycle, which costs the same for one pixel as for a whole span.
class FlowPattern {
 public:
  static FlowPattern Always();
  static FlowPattern OneInFour();
  static FlowPattern Random(uint32_t seed);  // period 65536, half of the cycles willing

  // "0010111": a recorded pattern, repeated. Throws std::invalid_argument when it is empty, holds
  // another character, or never becomes 1.
  static FlowPattern Recorded(std::string_view bits);

  bool always() const { return willing_.size() == bits_.size(); }
  int64_t period() const { return static_cast<int64_t>(bits_.size()); }
  bool At(int64_t cycle) const { return bits_[static_cast<size_t>(cycle % period())] != 0; }

  // Number of willing cycles before `cycle`.
  int64_t Rank(int64_t cycle) const {
    return cycle / period() * count() + rank_[static_cast<size_t>(cycle % period())];
  }
  // The willing cycle that has `rank` willing cycles before it: Select(Rank(c)) is the first
  // willing cycle at or after c.
  int64_t Select(int64_t rank) const {
    return rank / count() * period() + willing_[static_cast<size_t>(rank % count())];
  }
  int64_t Next(int64_t cycle) const { return always() ? cycle : Select(Rank(cycle)); }

  // Triangles and spans follow one source pattern, triangles a few cycles ahead in it, so that each
  // meets the other early and late.
  static constexpr int64_t kTriangleLead = 3;

  int64_t longest_gap() const { return longest_gap_; }  // unwilling cycles in a row

 private:
  explicit FlowPattern(std::vector<uint8_t> bits);
  int64_t count() const { return static_cast<int64_t>(willing_.size()); }

  std::vector<uint8_t> bits_;
  std::vector<int64_t> rank_;     // willing cycles before each cycle of the period
  std::vector<int64_t> willing_;  // the willing cycles of the period
  int64_t longest_gap_ = 0;
};

}  // namespace shading
