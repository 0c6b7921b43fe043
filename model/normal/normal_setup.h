// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/light_types.h"
#include "model/normal/normal_types.h"
#include "model/normal/stage_clock.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/normal_setup.sv: seeds of the recurrences along a span of m steps,
// without arccos, square root or trigonometry. With delta = |Nb - Na|^2 / 2 and phi = psi / m:
//
//   psi^2 = 2 delta G(delta)             phi^2 = psi^2 / m^2
//   kappa = 4 sin^2(phi/2) = phi^2 K(phi^2)
//   r = sin(phi) / sin(psi) = R(delta) S(phi^2) / m
//   s(1) - s(0) = sb r - sa g            g = (1 - delta) r + kappa/2        paper 000 (3), (6)
//   linear    r = g = 1/m, kappa = 0
//   |N|^2     q(1) - q(0) = 2 Na.(Nb - Na) / m + |Nb - Na|^2 / m^2, curvature 2 |Nb - Na|^2 / m^2
//
// G, R, K, S and 1/m are tables of quadratics, exact at 0 and at powers of 2. Every product is
// rounded half up once; sums wrap. m = 0 and m = 1 count as m = 1 and have kappa = 0.
//
// Timing: kStages stages of kSteps cycles each. Span k enters stage j in cycle s(k, j) and is on
// offer from the cycle after s(k, n), n = StageCount(lanes):
//   s(k, 0) >= s(k-1, 1)                  the cycle in which the span is accepted
//   s(k, j+1) = max(s(k, j) + kSteps, s(k-1, j+2))      where s(k-1, n+1) is when its seed is taken
//
// Bad input: delta saturates at 1 + 2^-7 (spherical spans beyond 90.4 degrees); sums wrap.
class NormalSetup {
 public:
  static constexpr UnitContract kContract = {
      "normal_setup",
      "normal",
      33,
      8,
      "normals S1.30, light vectors S1.22, 0..4095 steps",
      "quantities S1.38, squared length S1.44, kappa U1.28 4^-p",
      64,
      "slerp of unit normals up to 90 degrees, ulp of 2^-30 at any pixel, exact recurrence"};

  static constexpr int kSteps = StageClock::kSteps;
  static constexpr int kStages = 4;  // with one lane; four lanes take one more
  static constexpr int StageCount(int lanes) { return lanes == 1 ? kStages : kStages + 1; }
  static constexpr int Latency(int lanes) { return kSteps * StageCount(lanes) + 1; }

  // lanes: 1 or 4. One lane leaves step_kappa and the seeds of the other lanes 0. The stride's
  // kappa saturates at 1, which needs a span that ends before it is used: m < 8 for four pixels,
  // m < 4 for two.
  static void Seed(const SetupKind& kind, const LightState& light, const SpanCommand& span,
                   int lanes, NormalSeed* seed);
};

}  // namespace shading
