// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_segment.sv: one channel of one span, paper 003, in segments
// of 2^k pixels with a line in each.
//
//   I(x+2^k) = I(x) + 2^(k+1) A x + 2^(2k) A + 2^k (Cy + D) = I(x) + 2^k slope
//   slope = I(x+1) - I(x) + (2^k - 1) A, and 2^k 2A more from segment to segment
//
// k, 0..11, is the largest whose line stays within the tolerance: |A| 4^k / 4 <= tolerance. The
// ends of segments are exact. Sums wrap, and so does 2A: half of the wrapped 2A gives a curve that
// is the true one modulo 2^36 at every pixel, and the line is within the tolerance of that curve.
// Seeds rounded to 2^-27 codes move pixel t by (t^2 + 1) 2^-27 codes more; an odd 2A by t
// 2^-27.
template <typename Word = uint64_t>
class BasicQuadSegment {
 public:
  static constexpr UnitContract kContract = {
      "quad_segment",
      "intensity",
      1,
      1,
      "seed S9.26, tolerance U4.12",
      "code U8.0, truncate, clamp",
      0.0313,
      "beyond the tolerance, even 2A, spans of 2048 pixels, before the code is rounded"};

  static constexpr int kMostShift = 11;  // segments of 2048 pixels

  // k: |2A| 4^k <= 8 tolerance, in units of 2^-26 codes, without a shift to the left.
  static int ShiftOf(IntensityAcc curvature, Tolerance tolerance) {
    constexpr int kUnits = IntensityAcc::kFraction - Tolerance::kFraction;
    const int64_t limit = tolerance.raw() << (kUnits + 3);
    const int64_t magnitude = curvature.raw() < 0 ? -curvature.raw() : curvature.raw();
    int k = 0;
    while (k < kMostShift && magnitude <= limit >> (2 * (k + 1))) ++k;
    return k;
  }

  BasicQuadSegment(const ChannelSeed& seed, Tolerance tolerance)
      : shift_(ShiftOf(seed.curvature, tolerance)), current_(ToWord<Word>(seed.first)) {
    const Word a = ToWord<Word>(IntensityAcc::FromRaw(seed.curvature.raw() >> 1));
    slope_ = ToWord<Word>(seed.difference) + (a << shift_) - a;
    bend_ = ToWord<Word>(seed.curvature) << shift_;
  }

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const { return WholeCodes(Bits(current_)); }  // before the clamp
  IntensityAcc value() const { return FromAligned<IntensityAcc>(Bits(current_)); }
  int shift() const { return shift_; }  // k
  void Step() {
    current_ = current_ + slope_;
    if ((++t_ & ((1u << shift_) - 1)) == 0) slope_ = slope_ + bend_;
  }

 private:
  int shift_;  // k
  unsigned t_ = 0;
  Word current_;             // I(t) on its line
  Word slope_{0}, bend_{0};  // bend: 2^k 2A
};

using QuadSegment = BasicQuadSegment<>;

}  // namespace shading
