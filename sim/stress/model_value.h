// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/word.h"
#include "model/raster/pixel_walker.h"

namespace shading::stress {

// The word of a unit's registers, which remembers what the unit showed last: its accumulator
// before the fraction is dropped.
class SeenWord {
 public:
  explicit SeenWord(uint64_t bits) : bits_(bits) {}
  SeenWord operator+(SeenWord b) const { return SeenWord(bits_ + b.bits_); }
  SeenWord operator-(SeenWord b) const { return SeenWord(bits_ - b.bits_); }
  SeenWord operator*(SeenWord b) const { return SeenWord(bits_ * b.bits_); }
  SeenWord operator<<(int n) const { return SeenWord(bits_ << n); }
  SeenWord operator>>(int n) const { return SeenWord(bits_ >> n); }

  friend uint64_t Bits(const SeenWord& word) { return seen_ = word.bits_; }
  static IntensityAcc Seen() { return FromAligned<IntensityAcc>(seen_); }

 private:
  inline static thread_local uint64_t seen_ = 0;
  uint64_t bits_;
};

// The accumulator of a unit after `steps` pixels.
template <typename Unit>
int64_t AfterSteps(Unit unit, int steps) {
  for (int t = 0; t < steps; ++t) unit.Step();
  (void)unit.whole();
  return SeenWord::Seen().raw();
}

// Of gouraud_interpolator, which shows whole codes: the sums wrap, so that seeds times 2^k show the
// bits k below.
inline int64_t GouraudAfter(int64_t first, int64_t difference, int steps) {
  uint64_t value = 0;
  for (const int k : {0, 10, 20, 26}) {
    const auto shifted = [&](int64_t raw) {
      return IntensityAcc::Wrap(static_cast<int64_t>(static_cast<uint64_t>(raw) << k));
    };
    GouraudInterpolator unit(ChannelSeed{shifted(first), {}, shifted(difference), {}});
    for (int t = 0; t < steps; ++t) unit.Step();
    value |= (static_cast<uint64_t>(unit.whole()) & 0x3ff) << (26 - k);
  }
  return IntensityAcc::Wrap(static_cast<int64_t>(value)).raw();
}

// Of pixel_walker, which shows U0.24: what is to be added so that it shows one more.
inline int64_t DepthAfter(int64_t first, int64_t difference, int steps) {
  constexpr int kGuard = DepthAcc::kFraction - Depth::kFraction;
  const auto shown = [&](int64_t more) {
    SpanSeed seed;
    seed.z = DepthAcc::Wrap(first + more);
    seed.dz_dx = DepthAcc::Wrap(difference);
    PixelWalker unit(seed);
    for (int t = 0; t < steps; ++t) unit.Step();
    return int64_t{unit.z()};
  };
  const int64_t depth = shown(0);
  int64_t low = 0, high = int64_t{1} << kGuard;  // shows the same, one more
  while (high - low > 1) {
    const int64_t middle = (low + high) / 2;
    (shown(middle) == depth ? low : high) = middle;
  }
  return ((depth + 1) << kGuard) - high;
}

}  // namespace shading::stress
