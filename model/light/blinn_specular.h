// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/light_types.h"
#include "model/light/specular_table.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/light/blinn_specular.sv: the highlight of paper 000 (1), (12), a cosine
// clamped to [0, 1] to the power of the shininess, by two tables of quadratics.
//
//   x^n = 2^-t,  t = n y,  y = -log2 x = z - log2(1 - u / 2)  with  x = (1 - u / 2) 2^-z
//   2^-t = 2^g 2^-octaves,  octaves = ceil t,  g = octaves - t
//
// |error| < 0.65 ulp of U1.16 for every x and n of 1..256. 0^n = 0 and 1^n = 1 exactly; rising in x
// and falling in n, for every truncation keeps the order. Shininess outside 1..256 is accepted:
// x^0 = 1 for x > 0, and the error grows with n.
class BlinnSpecular {
 public:
  static constexpr UnitContract kContract = {"blinn_specular",
                                             "light",
                                             8,
                                             1,
                                             "x S1.30, shininess U9.7",
                                             "highlight U1.16, round to nearest",
                                             0.65,
                                             "every x, shininess 1..256"};

  explicit BlinnSpecular(Shininess n);

  // Pixels outside the highlight cost one comparison.
  Highlight Of(Cosine x) const {
    return x.raw() < least_visible_ ? Highlight() : Power(ClampedRaw(x));
  }
  // The least cosine, 1..2^30, whose highlight is not 0.
  Cosine least_visible() const { return Cosine::FromRaw(least_visible_); }

  // Whether the power is computed at all.
  static bool Lit(Cosine x) { return x.raw() > 0; }

  // -log2 x in U5.30, for x in U1.30, 2^-30..1.
  static int64_t NegativeLog2(int64_t x) {
    // Leading zeros of x - 1 ulp as a number of 30 bits; 0 has 30.
    const int zeros = __builtin_clz((static_cast<uint32_t>(x - 1) << 2) | 3);
    const int64_t u = (((int64_t{1} << 30) - x) << zeros) & ((int64_t{1} << 29) - 1);
    const QuadraticSegment& segment = kLogTable[static_cast<size_t>(u >> 22)];
    const int64_t d = u & ((int64_t{1} << 22) - 1);
    const int64_t slope = segment.slope + ((segment.curvature * (d >> 4)) >> 20);
    return (static_cast<int64_t>(zeros) << 30) + segment.value + ((slope * d) >> 21);
  }

  // 2^g in U2.22, for g in U0.23.
  static int64_t Exp2(int64_t g) {
    const QuadraticSegment& segment = kExpTable[static_cast<size_t>(g >> 18)];
    const int64_t d = g & ((int64_t{1} << 18) - 1);
    const int64_t slope = segment.slope + ((segment.curvature * (d >> 5)) >> 14);
    return segment.value + ((slope * d) >> 18);
  }

 private:
  // For x in U1.30, 2^-30..1.
  Highlight Power(int64_t x) const {
    constexpr int64_t kOne = int64_t{1} << 23;
    const int64_t t = (NegativeLog2(x) * n_) >> 14;  // U14.23
    const int64_t octaves = (t + kOne - 1) >> 23;
    if (octaves > Highlight::kFraction + 1) return Highlight();
    const int shift = 6 + static_cast<int>(octaves);
    const int64_t power = Exp2(octaves * kOne - t);
    return Highlight::FromRaw((power + (int64_t{1} << (shift - 1))) >> shift);
  }

  int64_t n_;
  int64_t least_visible_;
};

}  // namespace shading
