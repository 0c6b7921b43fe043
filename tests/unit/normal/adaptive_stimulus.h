// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/normal/adaptive_normalizer.h"
#include "tests/unit/normal/arc_stimulus.h"

namespace shading {

inline constexpr Real kDegree = kQuarterTurn / 90;

// The limit that keeps |N.L| and (N.H)^n within `tolerance` codes, rounded down: paper 002.
//   |N.L|: delta = 1 - cos(eta/2) <= tol      (N.H)^n, n >= 2: n (1 - cos eta) / 4 <= tol
inline AngleLimit LimitOf(Real tolerance, int n) {
  const Real tol = tolerance / 255;
  const Real diffuse = 4 * tol - 2 * tol * tol, specular = 4 * tol / n;
  return AngleLimit::FromRaw(
      static_cast<int64_t>(std::ldexp(n == 1 ? diffuse : std::min(diffuse, specular), 30)));
}

// 0.001 .. 1 of the largest, small ones as often as large ones; a quarter of them near it.
inline Real RandomTurnUpTo(Real most, std::mt19937& random) {
  return RandomTurn(random) / kQuarterTurn * most;
}

inline int RandomAdaptiveLength(int most, std::mt19937& random) {
  switch (random() % 4) {
    case 0: return 1 + static_cast<int>(random() % 5);
    case 1: return 1 + static_cast<int>(random() % 32);
    case 2: return std::min(most, (1 << (random() % 12)) + static_cast<int>(random() % 3));
    default: return 1 + static_cast<int>(random() % static_cast<uint32_t>(most));
  }
}

// Small limits, large ones, and those of materials.
inline AngleLimit RandomLimit(std::mt19937& random) {
  constexpr uint32_t kMost = (1u << AngleLimit::kWidth) - 1;
  switch (random() % 8) {
    case 0: return AngleLimit::FromRaw(random() % 2 ? 0 : kMost);
    case 1: return AngleLimit::FromRaw((random() & kMost) >> (random() % 24));
    default: break;
  }
  return LimitOf(std::ldexp(0.5L, static_cast<int>(random() % 5)), 1 << (random() % 9));
}

}  // namespace shading
