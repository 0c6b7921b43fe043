// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <random>

#include "model/normal/normal_setup.h"
#include "model/normal/slerp_direct_setup.h"
#include "tests/unit/normal/quantity_stimulus.h"

namespace shading {

using RealVector = std::array<Real, 3>;

inline Real Dot(const RealVector& a, const RealVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline RealVector Unit(const RealVector& v) {
  const Real length = std::sqrt(Dot(v, v));
  return {v[0] / length, v[1] / length, v[2] / length};
}
inline RealVector RealOf(const SpanNormal& n) {
  RealVector v;
  for (size_t i = 0; i < 3; ++i) v[i] = std::ldexp(static_cast<Real>(n[i].raw()), -30);
  return v;
}
inline SpanNormal RoundNormal(const RealVector& v) {
  SpanNormal normal;
  for (size_t i = 0; i < 3; ++i) normal[i] = SpanNormalComponent::Round(static_cast<double>(v[i]));
  return normal;
}

// Two directions; the second is the part of its vector at right angles to the first. A third of
// them lies near the axes.
struct Plane {
  RealVector start, side;
};
inline Plane PlaneOf(const RealVector& a, const RealVector& other) {
  const RealVector start = Unit(a);
  RealVector side;
  for (size_t i = 0; i < 3; ++i) side[i] = other[i] - Dot(other, start) * start[i];
  return {start, Unit(side)};
}
inline Plane RandomPlane(std::mt19937& random) {
  std::normal_distribution<double> gauss;
  RealVector a = {gauss(random), gauss(random), gauss(random)};
  RealVector b = {gauss(random), gauss(random), gauss(random)};
  if (random() % 3 == 0) {
    a[random() % 3] *= 1000;
    b[random() % 3] *= 1000;
  }
  return PlaneOf(a, b);
}

// Ends of a span of `length` pixels that turns by `turn`.
inline SpanCommand SpanOf(const Plane& plane, Real turn, int length) {
  RealVector end;
  for (size_t i = 0; i < 3; ++i) {
    end[i] = std::cos(turn) * plane.start[i] + std::sin(turn) * plane.side[i];
  }
  SpanCommand span;
  span.length = length;
  span.normal = {RoundNormal(plane.start), RoundNormal(end)};
  return span;
}

struct PixelSeed {
  std::array<QuantitySeed, 3> quantity;
  Kappa kappa;
};

// Seed of a stride of one pixel.
inline PixelSeed SeedOf(const SpanCommand& span, int lanes = 1) {
  NormalSeed seed;
  NormalSetup::Seed({true, false, false}, {}, span, lanes, &seed);
  PixelSeed pixel;
  for (size_t i = 0; i < 3; ++i) {
    pixel.quantity[i] = seed.quantity[i][0];
    if (lanes == 1) continue;
    const int64_t next = seed.quantity[i][1].first.raw();
    pixel.quantity[i].difference = Quantity::Wrap(next - pixel.quantity[i].first.raw());
  }
  pixel.kappa = lanes == 1 ? seed.kappa : seed.step_kappa[0];
  return pixel;
}

// 1e-4 .. 90 degrees, small angles as often as large ones, a quarter of them near 90.
inline Real RandomTurn(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  if (random() % 4 == 0) return kQuarterTurn * (1 - 0.05L * unit(random));
  return kQuarterTurn * std::pow(10.0L, -5.9543L * unit(random));
}

}  // namespace shading
