// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/flat_color.h"
#include "model/intensity/point_registers.h"

namespace shading {

// Bit-exact model of rtl/intensity/quad_polynomial.sv: one channel of one span, paper 003 (2),
// eight products for every pixel.
//
//   I(x, y) = A x^2 + B y^2 + C x y + D x + E y + F
//
// Sums and products modulo 2^36 of integers: exact. Coefficients rounded to 2^-27 codes move a
// pixel by (x^2 + |x y| + y^2 + |x| + |y| + 1) 2^-27 codes.
template <typename Word = uint64_t>
class BasicQuadPolynomial : public PointRegisters<Word> {
 public:
  static constexpr UnitContract kContract = {"quad_polynomial",
                                             "intensity",
                                             1,
                                             1,
                                             "coefficients S9.26, coordinates S12.0",
                                             "code U8.0, truncate, clamp",
                                             0.0938,
                                             "offsets of -2047..2047, before the code is rounded"};

  explicit BasicQuadPolynomial(const SurfacePoint& point, int lane = 0, int lanes = 1)
      : PointRegisters<Word>(point, lane, lanes) {}

  uint8_t code() const { return ClampCode(whole()); }
  int64_t whole() const {  // before the clamp
    const Word x = this->x(), y = this->y();
    const Word second_order = a_ * x * x + b_ * y * y + c_ * x * y;
    return WholeCodes(Bits(second_order + d_ * x + e_ * y + f_));
  }

 private:
  using PointRegisters<Word>::a_;
  using PointRegisters<Word>::b_;
  using PointRegisters<Word>::c_;
  using PointRegisters<Word>::d_;
  using PointRegisters<Word>::e_;
  using PointRegisters<Word>::f_;
};

using QuadPolynomial = BasicQuadPolynomial<>;

}  // namespace shading
