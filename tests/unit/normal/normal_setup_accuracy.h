// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/normal/arc_stimulus.h"

namespace shading {

// Largest distance from slerp, in ulp of 2^-30, of an exact recurrence that starts from the seeds.
inline Real SetupDistance(const SpanCommand& span, int lanes) {
  NormalSeed seed;
  NormalSetup::Seed({true, false, false}, {}, span, lanes, &seed);
  const Real turn = TurnOf(span);
  const int m = span.length - 1;
  const Real kappa =
      std::ldexp(static_cast<Real>(seed.kappa.mantissa.raw()), -28 - 2 * seed.kappa.exponent);
  Real worst = 0;
  for (int lane = 0; lane < std::min(lanes, m + 1); ++lane) {
    RealVector s, d;
    for (size_t i = 0; i < 3; ++i) {
      const QuantitySeed& start = seed.quantity[i][static_cast<size_t>(lane)];
      s[i] = start.first.ToReal();
      d[i] = start.difference.ToReal();
    }
    for (int t = lane; t <= m; t += lanes) {
      const RealVector ideal = SlerpOf(span, turn, static_cast<Real>(t) / m);
      for (size_t i = 0; i < 3; ++i) {
        worst = std::max(worst, std::abs(s[i] - ideal[i]));
        s[i] += d[i];
        d[i] -= kappa * s[i];
      }
    }
  }
  return std::ldexp(worst, 30);
}

// A span in the search for the worst one.
struct SetupPoint {
  RealVector start, side;  // of the plane, of any length
  Real turn = 0;           // up to 90 degrees
  int steps = 1;           // 1..4095
  double error = 0;
};

inline void Evaluate(int lanes, SetupPoint* point) {
  const SpanCommand span =
      SpanOf(PlaneOf(point->start, point->side), point->turn, point->steps + 1);
  point->error = static_cast<double>(SetupDistance(span, lanes));
}

// Half of them near 90 degrees, where the phase counts most.
inline SetupPoint RandomSetupPoint(std::mt19937& random) {
  const Plane plane = RandomPlane(random);
  SetupPoint point{plane.start, plane.side, 0, 0, 0};
  point.turn = random() % 2 ? kQuarterTurn * (1 - static_cast<Real>(random() % 1000) / 20000)
                            : RandomTurn(random);
  point.steps = 1 + static_cast<int>(random() % (random() % 3 ? 400 : 4095));
  return point;
}

// One of direction, angle and length moves, by about `size` of its range.
inline SetupPoint MovedSetupPoint(SetupPoint point, Real size, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  switch (random() % 3) {
    case 0:
      for (size_t i = 0; i < 3; ++i) {
        point.start[i] += size * static_cast<Real>(gauss(random));
        point.side[i] += size * static_cast<Real>(gauss(random));
      }
      break;
    case 1:
      point.turn *= 1 + size * static_cast<Real>(gauss(random));
      point.turn = std::min(std::abs(point.turn), kQuarterTurn);
      break;
    default: {
      const auto move = static_cast<int>(4095 * size * static_cast<Real>(gauss(random)));
      const int least = random() % 2 ? 1 : -1;
      point.steps = std::clamp(point.steps + move + least, 1, 4095);
    }
  }
  return point;
}

// Random spans, then climbs from the worst of them.
inline SetupPoint WorstSetup(int lanes) {
  constexpr int kClimbs = 8, kStarts = 150, kMoves = 350;
  std::mt19937 random(1);
  SetupPoint worst;
  for (int climb = 0; climb < kClimbs; ++climb) {
    SetupPoint best;
    for (int i = 0; i < kStarts + kMoves; ++i) {
      const Real size = 0.1L * std::pow(0.98L, static_cast<Real>(i - kStarts));
      SetupPoint point =
          i < kStarts ? RandomSetupPoint(random) : MovedSetupPoint(best, size, random);
      Evaluate(lanes, &point);
      if (point.error > best.error) best = point;
    }
    if (best.error > worst.error) worst = best;
  }
  return worst;
}

}  // namespace shading
