// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_horner.sv: one channel of one span, paper 003 (9), five
// products for every pixel.
//
//   I(x, y) = x (A x + C y + D) + y (B y + E) + F
//
// Sums and products modulo 2^36 of integers: exact. Coefficients rounded to 2^-27 codes move a
// pixel by (x^2 + |x y| + y^2 + |x| + |y| + 1) 2^-27 codes.
template <typename Word = uint64_t>
class BasicQuadHorner {
 public:
  static constexpr UnitContract kContract = {"quad_horner",
                                             "intensity",
                                             1,
                                             1,
                                             "coefficients S9.26, coordinates S12.0",
                                             "code U8.0, truncate, clamp",
                                             0.0938,
                                             "offsets of -2047..2047, before the code is rounded"};

  explicit BasicQuadHorner(const SurfacePoint& point, int lane = 0, int lanes = 1)
      : a_(ToWord<Word>(point.surface.a)),
        b_(ToWord<Word>(point.surface.b)),
        c_(ToWord<Word>(point.surface.c)),
        d_(ToWord<Word>(point.surface.d)),
        e_(ToWord<Word>(point.surface.e)),
        f_(ToWord<Word>(point.surface.f)),
        x_(point.x + lane),
        y_(point.y),
        stride_(lanes) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const {  // before the clamp
    const Word x(static_cast<uint64_t>(x_)), y(static_cast<uint64_t>(y_));
    const Word value = (a_ * x + c_ * y + d_) * x + (b_ * y + e_) * y + f_;
    return WholeCodes(Bits(value));
  }
  void Step() { x_ += stride_; }

 private:
  Word a_, b_, c_, d_, e_, f_;
  int64_t x_, y_;
  int64_t stride_;
};

using QuadHorner = BasicQuadHorner<>;

}  // namespace shading
