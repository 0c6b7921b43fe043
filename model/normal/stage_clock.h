// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace shading {

// Cycles of rtl/normal/normal_setup_control.sv: kStages stages of kSteps cycles each, and the
// register from which the result is on offer.
//
//   s(k, j+1) = max(s(k, j) + kSteps, s(k-1, j+2))      the cycle in which span k enters stage j +
//   1
class StageClock {
 public:
  static constexpr int kSteps = 8;
  static constexpr size_t kMostStages = 5;

  explicit StageClock(int stages) : stages_(static_cast<size_t>(stages)) {}

  // The first cycle in which stage 0 takes another span.
  int64_t free() const { return entered_[1]; }

  // A span enters stage 0; the register gives up the span before in cycle `register_free`. Returns
  // the first cycle in which the span's result is on offer.
  int64_t Offer(int64_t entered, int64_t register_free) {
    entered_[0] = entered;
    entered_[stages_ + 1] = register_free;
    for (size_t j = 1; j <= stages_; ++j) {
      entered_[j] = std::max(entered_[j - 1] + kSteps, entered_[j + 1]);
    }
    return entered_[stages_] + 1;
  }

 private:
  size_t stages_;
  std::array<int64_t, kMostStages + 2> entered_ = {};  // of the latest span
};

}  // namespace shading
