// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/slerp_direct_setup.sv: from the seed of a recurrence to the arc of
// paper 000 (6), with d = N(1) - N(0) and kappa = 4 sin^2(phi/2) = X 4^-E, X in [1, 4):
//
//   phi = sqrt(kappa) A(kappa)                    A(x) = 2 asin(sqrt(x)/2) / sqrt(x)
//   1/sin(phi) = B(kappa) / sqrt(kappa)           B(x) = 1 / sqrt(1 - x/4)
//   Nk = (N(1) - Na cos(phi)) / sin(phi) = (d + Na kappa/2) / sin(phi)
//   1/sqrt(X) by ReciprocalSqrt and one step of Newton
//
// kappa = 0 stands for phi < 2^-24.5, for spans that turn less than 2^-18.5, and for one step:
//   all |d| < 2^-24    phi = 2^-25, Nk = 2^25 d: Na + t d up to 2^-27 in 4095 steps
//   all |d| < 2^-19    phi = 2^-20, Nk = 2^20 d: such spans have at most 46 steps
//   else               phi = a quarter of a turn, Nk = Na + d: right at both pixels of the span
//
// Timing: kStages stages of NormalSetup::kSteps cycles, and the rule of NormalSetup:
//   s(k, 0) >= s(k-1, 1)
//   s(k, j+1) = max(s(k, j) + kSteps, s(k-1, j+2))      where s(k-1, n+1) is when its arc is taken
// An arc is on offer from the cycle after s(k, n), n = kStages.
//
// Bad input: kappa saturates at 0.625 in A and B; Nk saturates; first drops bits beyond S1.30,
// which normals at the ends of spans lack.
class SlerpDirectSetup {
 public:
  static constexpr UnitContract kContract = {
      "slerp_direct_setup",
      "normal",
      17,
      8,
      "first and difference S1.38, kappa U1.28 4^-p",
      "angle U1.40, normals S1.30",
      9,
      "ulp of 2^-30 at any of 4096 pixels, kappa <= 0.625, arcs up to 90 degrees"};

  static constexpr int kStages = 2;

  // Seeds and kappa of a stride of one pixel.
  static SpanArc Of(const std::array<QuantitySeed, 3>& seed, const Kappa& kappa);
};

}  // namespace shading
