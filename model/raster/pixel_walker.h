// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/raster/pixel_walker.sv: position and depth along one span.
//
//   x(i) = x + i,   z(i) = z + i dz/dx
//
// dz/dx rounded to 2^-39 moves pixel i by i 2^-39: at most 1/8 ulp of U0.24 for 4096 pixels.
class PixelWalker {
 public:
  static constexpr UnitContract kContract = {"pixel_walker",
                                             "raster",
                                             1,
                                             1,
                                             "depth S1.38",
                                             "depth U0.24, truncate, clamp",
                                             0.125,
                                             "spans of 4096 pixels, before z is rounded"};

  explicit PixelWalker(const SpanSeed& seed)
      : z_(Align(seed.z)),
        dz_dx_(Align(seed.dz_dx)),
        x_(static_cast<uint16_t>(seed.x)),
        y_(static_cast<uint16_t>(seed.y)) {}

  uint16_t x() const { return x_; }
  uint16_t y() const { return y_; }
  uint32_t z() const {
    constexpr int kShift = 64 - DepthAcc::kWidth + DepthAcc::kFraction - Depth::kFraction;
    const int64_t z = static_cast<int64_t>(z_) >> kShift;
    // Out of range only by rounding: a branch that is nearly never taken costs least.
    if (static_cast<uint64_t>(z) <= Depth::kMaxRaw) return static_cast<uint32_t>(z);
    return z < 0 ? 0 : static_cast<uint32_t>(Depth::kMaxRaw);
  }
  void Step() {
    ++x_;
    z_ += dz_dx_;
  }

 private:
  uint64_t z_;
  uint64_t dz_dx_;
  uint16_t x_;
  uint16_t y_;
};

}  // namespace shading
