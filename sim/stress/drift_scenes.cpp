// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>

#include "model/contracts.h"
#include "model/normal/edge_normals.h"
#include "model/raster/span_setup.h"
#include "sim/stress/model_value.h"
#include "sim/stress/narrow_recurrence.h"
#include "sim/stress/search.h"
#include "sim/stress/span_arcs.h"
#include "sim/stress/trouble.h"

namespace shading::stress {
namespace {

constexpr int kFraction = IntensityAcc::kFraction;

// The far corner of 4096 x 4096 pixels: rows by span_setup, then columns by the unit; six
// coefficients whose parts below an ulp are operands, against the polynomial.
template <typename Unit>
double CornerError(const Genes& g) {
  constexpr int kFar = kMaxScreen - 1;
  const std::array<Real, 6> term = {Real{kFar} * kFar, Real{kFar} * kFar, Real{kFar} * kFar,
                                    Real{kFar},        Real{kFar},        1};
  const std::array<int64_t, 6> whole = {7, -9, 5, 1 << 10, -(1 << 9), int64_t{100} << kFraction};
  Real ideal = 0;
  std::array<IntensityAcc, 6> kept;
  for (size_t i = 0; i < 6; ++i) {
    const Real real = static_cast<Real>(whole[i]) + static_cast<Real>(g[i]) - 0.5L;
    ideal += real * term[i];
    kept[i] = IntensityAcc::Wrap(std::llround(real));
  }
  TriangleState triangle;
  triangle.surface[0] = {kept[0], kept[1], kept[2], kept[3], kept[4], kept[5]};
  SpanCommand span;
  span.y = kFar;
  span.length = kMaxScreen;
  const ChannelSeed seed = SpanSetup::Seed(Method::kQuad, triangle, span).channel[0];
  const Real off = static_cast<Real>(AfterSteps(Unit(seed), kFar)) - ideal;
  return static_cast<double>(std::ldexp(
      std::abs(std::remainder(off, std::ldexp(1.0L, IntensityAcc::kWidth))), -kFraction));
}

template <typename Unit>
Scene Corner(const std::string& unit) {
  return [unit](bool quick, uint32_t seed) {
    Condition c{"drift", "rows, then columns: pixel (4095, 4095)", unit + ", codes"};
    Check check;
    check.genes = {"A", "B", "C", "D", "E", "F"};
    check.error = [](const Genes& g, int) { return CornerError<Unit>(g); };
    check.starts = {Genes(6, 1e-12), Genes(6, 1 - 1e-12)};
    const Worst worst = Search(check, quick ? 3000 : 100000, seed);
    c.cases = worst.evaluations;
    c.worst = worst.error;
    // Half an ulp a coefficient: (3 4095^2 + 2 4095 + 1) 2^-27.
    c.limit = std::ldexp(3.0 * 4095 * 4095 + 2 * 4095 + 1, -kFraction - 1);
    return c;
  };
}

// Normals down an edge of 4096 rows, then along the last row of 4096 pixels by normal_setup and
// slerp_recurrence, against slerp of slerp.
double NormalCornerError(const Genes& g) {
  const GreatArc down = GreatArc::Of(g);
  const Real turn = kPi / 180 * static_cast<Real>(Geometric(0.001, 179, g[3]));
  const Vector3 top = Rounded<NormalComponent>(down.start);
  const Vector3 bottom = Rounded<NormalComponent>(down.At(turn));
  const ArcVector a = UnitOf(top), b = UnitOf(bottom);
  EdgeNormals edge(0, int64_t{4096} * 256, a, b, 0);
  SpanCommand span;
  span.length = kMaxScreen;
  const ArcVector left = edge.At(kMaxScreen - 1);
  const GreatArc along{Unit(RealOf(top)), down.side};
  Vector start, first, last;
  for (size_t i = 0; i < 3; ++i) {
    start[i] = std::ldexp(static_cast<Real>(a[i]), -kArcFraction);
    last[i] = std::ldexp(static_cast<Real>(b[i]), -kArcFraction);
    span.normal[0][i] = SpanNormalComponent::FromRaw(RoundShift(left[i], kArcFraction - 30));
  }
  const Real psi = std::acos(std::clamp<Real>(Dot(start, last), -1, 1));
  const Real w = 4095.5L / 4096;
  if (psi < 1e-6L) return 0;
  for (size_t i = 0; i < 3; ++i)
    first[i] = (std::sin((1 - w) * psi) * start[i] + std::sin(w * psi) * last[i]) / std::sin(psi);
  const Real row = kPi / 180 * static_cast<Real>(Geometric(0.001, 89.9, g[4]));
  const Vector side = Unit(Cross(Cross(first, along.side), first));
  Vector end;
  for (size_t i = 0; i < 3; ++i) end[i] = std::cos(row) * first[i] + std::sin(row) * side[i];
  span.normal[1] = Rounded<SpanNormalComponent>(end);
  NormalSeed seed;
  NormalSetup::Seed({true, false, false}, {}, span, 1, &seed);
  Real worst = 0;
  for (size_t i = 0; i < 3; ++i) {
    SlerpRecurrence unit(seed.quantity[i][0], seed.kappa);
    for (int t = 0; t + 1 < kMaxScreen; ++t) unit.Step();
    Raise(&worst, std::abs(std::ldexp(static_cast<Real>(unit.value().raw()), -38) - end[i]));
  }
  return static_cast<double>(255 * worst);
}

Condition NormalCorner(bool quick, uint32_t seed) {
  Condition c{"drift", "normals down 4096 rows, then along 4096 columns: the last pixel",
              "edge, normal_setup, slerp_recurrence: codes of N.L along an axis"};
  Check check;
  check.genes = {"turn", "height", "plane", "turn of the edge", "turn of the row"};
  check.error = [](const Genes& g, int) { return NormalCornerError(g); };
  const Worst worst = Search(check, quick ? 1500 : 60000, seed);
  c.cases = worst.evaluations;
  c.worst = worst.error;
  // What the three state: 0.6 and 64 ulp of 2^-30 and half an ulp of 2^-38 a step, 4095^2 / 2 of
  // them, with the half ulp of the multiplier's operand: 2049 2^-39 a step of a dead zone.
  c.limit = 255 * (64.6 * 0x1p-30 + 4095.0 * 4095 / 2 * 0x1p-39 * 2049 / 2048);
  return c;
}

// What slerp_recurrence may err at pixel t, in ulp of 2^-38: half an ulp a step, which t^2 / 2 of
// them sum up, and start and first difference; kappa is within 2^-27 of itself, which turns the
// last pixel by t phi 2^-28, a little more for steps of 60 degrees; the operand within 2^-29.
Real GrowthLaw(int t, Real phi) {
  const Real turn = t * phi;
  return (0.5L * t * t + 1.5L * t + 1) / 2 + std::ldexp(1.15L * turn, 10) +
         std::ldexp(turn * turn, 8);
}

Real LastOff(const Arc& arc, int t) {
  SlerpRecurrence line(
      {Quantity::Wrap(RoundTo(arc.At(0), 38)), Quantity::Wrap(RoundTo(arc.FirstDifference(), 38))},
      KappaOf(arc.phi));
  for (int i = 0; i < t; ++i) line.Step();
  return std::abs(static_cast<Real>(line.value().raw()) - std::ldexp(arc.At(t), 38));
}

// The last pixel of spans of every length: dead zones, where kappa is just under half an ulp, and
// turns of up to 90 degrees by steps of up to 60.
Condition Lengths(bool quick, uint32_t seed) {
  Condition c{"drift", "slerp_recurrence on spans of 2..4096 pixels, turns of 0.001..90 degrees",
              "worst error over t^2 / 4 ulp of 2^-38 and what kappa turns"};
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int pixels = 2; pixels <= kMaxScreen; pixels += quick && pixels > 64 ? 37 : 1) {
    const int t = pixels - 1;
    for (int k = 0; k < (quick ? 8 : 40); ++k, ++c.cases) {
      const Real turn = kPi / 180 * static_cast<Real>(Geometric(0.001, 90, unit(random)));
      const Real phi = k % 2 ? std::sqrt(0.999L * 0x1p-39L) : std::min(turn / t, kPi / 3);
      const Arc arc{phi, k % 4 == 1 ? 0 : 2 * kPi * static_cast<Real>(unit(random))};
      c.worst = std::max(c.worst, static_cast<double>(LastOff(arc, t) / GrowthLaw(t, phi)));
    }
  }
  c.limit = 1;
  return c;
}

}  // namespace

std::vector<Scene> DriftScenes() {
  return {Corner<BasicQuadSurface<SeenWord>>("quad_surface"),
          Corner<BasicQuadStep<SeenWord>>("quad_step"),
          Corner<BasicQuadDifference<SeenWord>>("quad_difference"),
          Corner<BasicQuadThirdDifference<SeenWord>>("quad_third_difference"),
          NormalCorner,
          Lengths};
}

}  // namespace shading::stress
