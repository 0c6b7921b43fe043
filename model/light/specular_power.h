// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "model/light/cosine.h"
#include "model/unit_contract.h"

namespace shading {

using SpecularFactor = U<1, 30>;  // 0..1

// The highlight of paper 000 (1), (12), by shifts, additions and one product:
//
//   x^n = 2^-t,  t = n (-log2 x),  log2 x = sum of log2(1 + 2^-k) over the factors of x
//
// x is clamped to [0, 1] before the power. Factors are taken greedily, k = 1..40, each at most
// once; products are truncated to 46 fraction bits, t to 46, the result is rounded to nearest.
// |error| < 0.82 ulp of U1.30 (2^-30.3) for every x and n of 1..256. 0^n = 0 and 1^n = 1 exactly;
// a result under 2^-31 is 0; rising in x and falling in n.
// Shininess outside 1..256 is accepted: the error stays under 1 + n / 256 ulp, x^0 = 1 for x > 0.
class SpecularPower {
 public:
  static constexpr UnitContract kContract = {"specular_power",
                                             "light",
                                             0,
                                             0,
                                             "x S1.30, shininess U9.7",
                                             "U1.30, round to nearest",
                                             0.82,
                                             "every x, shininess 1..256"};
  static constexpr int kFraction = 46;
  static constexpr int kSteps = 40;

  // log2(1 + 2^-k) with 46 fraction bits, k = 1..40.
  static constexpr std::array<int64_t, kSteps> kLog2 = {
      0x2570068e7ef6, 0x149a784bcd1c, 0x0ae00d1cfdeb, 0x0598fdbeb245, 0x02d75a6eb1e0,
      0x016e79685c2d, 0x00b7f285b778, 0x005c2711b5eb, 0x002e1f07fe15, 0x001712653744,
      0x000b89eb17bd, 0x0005c523b0a8, 0x0002e29d623f, 0x0001715193b1, 0x0000b8a98280,
      0x00005c54ef6a, 0x00002e2a8340, 0x000017154483, 0x00000b8aa2fa, 0x000005c551ab,
      0x000002e2a8e1, 0x000001715473, 0x000000b8aa3a, 0x0000005c551d, 0x0000002e2a8f,
      0x000000171547, 0x0000000b8aa4, 0x00000005c552, 0x00000002e2a9, 0x000000017154,
      0x00000000b8aa, 0x000000005c55, 0x000000002e2b, 0x000000001715, 0x000000000b8b,
      0x0000000005c5, 0x0000000002e3, 0x000000000171, 0x0000000000b9, 0x00000000005c};

  static SpecularFactor Of(Cosine x, Shininess n);
};

}  // namespace shading
