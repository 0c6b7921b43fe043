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

// The angle between the ends of a span, and slerp between them at w = 0 .. 1.
inline Real TurnOf(const SpanCommand& span) {
  const RealVector a = Unit(RealOf(span.normal[0])), b = Unit(RealOf(span.normal[1]));
  const RealVector chord = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  return 2 * std::asin(std::sqrt(Dot(chord, chord)) / 2);
}
inline RealVector SlerpOf(const SpanCommand& span, Real turn, Real w) {
  const RealVector a = RealOf(span.normal[0]), b = RealOf(span.normal[1]);
  const Real wa = turn == 0 ? 1 - w : std::sin((1 - w) * turn) / std::sin(turn);
  const Real wb = turn == 0 ? w : std::sin(w * turn) / std::sin(turn);
  return {wa * a[0] + wb * b[0], wa * a[1] + wb * b[1], wa * a[2] + wb * b[2]};
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

inline SpanArc ArcOf(const Plane& plane, Real step) {
  return {Angle::FromRaw(std::llround(std::ldexp(step, Angle::kFraction))),
          RoundNormal(plane.start), RoundNormal(plane.side)};
}

// Of a span, or any bits.
inline SpanArc RandomSpanArc(int length, std::mt19937& random) {
  SpanArc arc;
  if (random() % 4) {
    const PixelSeed seed = SeedOf(SpanOf(RandomPlane(random), RandomTurn(random), length));
    return SlerpDirectSetup::Of(seed.quantity, seed.kappa);
  }
  const auto bits = [&random] {
    const auto word = static_cast<int32_t>(random());
    return SpanNormalComponent::FromRaw(random() % 8   ? word >> (random() % 32)
                                        : random() % 2 ? INT32_MIN
                                                       : INT32_MAX);
  };
  for (size_t i = 0; i < 3; ++i) arc.start[i] = bits(), arc.side[i] = bits();
  const uint64_t step = static_cast<uint64_t>(random()) << 32 | random();
  arc.step = Angle::FromRaw(static_cast<int64_t>(step >> (23 + random() % 41)));
  return arc;
}

}  // namespace shading
