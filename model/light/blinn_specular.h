// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/light_types.h"
#include "model/light/specular_math.h"
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
    if (x.raw() < least_visible_) return Highlight();
    return Highlight::FromRaw(SpecularMath::Power(static_cast<int32_t>(ClampedRaw(x)), n_));
  }
  // The least cosine, 1..2^30, whose highlight is not 0.
  Cosine least_visible() const { return Cosine::FromRaw(least_visible_); }
  uint32_t raw_shininess() const { return n_; }

  // Whether the power is computed at all.
  static bool Lit(Cosine x) { return x.raw() > 0; }

  // -log2 x in U5.30, for x in U1.30, 2^-30..1.
  static int64_t NegativeLog2(int64_t x) {
    const SpecularMath::Octave octave = SpecularMath::OctaveOf(static_cast<int32_t>(x));
    return (int64_t{octave.zeros} << 30) + SpecularMath::Log(octave.u);
  }
  // 2^g in U2.22, for g in U0.23.
  static int64_t Exp2(int64_t g) { return SpecularMath::Exp2(static_cast<int32_t>(g)); }

 private:
  uint32_t n_;
  int32_t least_visible_;
};

}  // namespace shading
