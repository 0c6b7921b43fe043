// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"

namespace shading {

// Bit-exact model of rtl/intensity/gouraud_interpolator.sv: one channel of one span.
//
//   I(x+1) = I(x) + D
//
// The recurrence is exact; D rounded to 2^-27 codes moves pixel t by at most t 2^-27 codes.
class GouraudInterpolator {
 public:
  static constexpr UnitContract kContract = {"gouraud_interpolator",
                                             "intensity",
                                             1,
                                             1,
                                             "seed S9.26",
                                             "code U8.0, truncate, clamp",
                                             3.1e-5,
                                             "spans of 4096 pixels, before the code is rounded"};

  explicit GouraudInterpolator(const ChannelSeed& seed)
      : current_(Align(seed.first)), difference_(Align(seed.difference)) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(current_); }  // before the clamp
  void Step() { current_ += difference_; }

 private:
  uint64_t current_;  // I(x)
  uint64_t difference_;
};

}  // namespace shading
