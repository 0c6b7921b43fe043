// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "tests/unit/normal/adaptive_stimulus.h"

namespace shading {

inline RealVector Cross(const RealVector& a, const RealVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// A span's ideal: slerp, or Phong's normalised chord.
struct IdealSpan {
  SpanCommand span;
  Real turn = 0;
  RealVector pole = {};
  bool chord = false;

  IdealSpan(const Plane& plane, Real angle, int length, bool on_chord)
      : span(SpanOf(plane, angle, length)),
        turn(TurnOf(span)),
        pole(Cross(plane.start, plane.side)),
        chord(on_chord) {}
  RealVector At(int pixel) const {
    const Real w = span.length == 1 ? 0 : static_cast<Real>(pixel) / (span.length - 1);
    if (!chord) return SlerpOf(span, turn, w);
    const RealVector a = RealOf(span.normal[0]), b = RealOf(span.normal[1]);
    return Unit({a[0] + w * (b[0] - a[0]), a[1] + w * (b[1] - a[1]), a[2] + w * (b[2] - a[2])});
  }
};

// |error| in codes of a full-scale component: of N.L with the worst L, and of (N.H)^n with H in the
// plane of the span, at and beside the ideal normal. The error grows with the angle out of the
// plane nowhere.
inline Real ErrorOf(const PixelNormal& normal, const RealVector& ideal, const RealVector& pole,
                    int n) {
  RealVector actual;
  for (size_t i = 0; i < 3; ++i) actual[i] = std::ldexp(static_cast<Real>(normal[i].raw()), -24);
  const RealVector off = {actual[0] - ideal[0], actual[1] - ideal[1], actual[2] - ideal[2]};
  if (n == 1) return 255 * std::sqrt(Dot(off, off));
  const RealVector along = Cross(pole, ideal);
  Real worst = 0;
  for (const double side : {0.0, 0.5, 1.0, 1.5}) {
    for (const double sign : {-1.0, 1.0}) {
      const Real angle = sign * side / std::sqrt(static_cast<double>(n));
      RealVector h;
      for (size_t i = 0; i < 3; ++i) h[i] = std::cos(angle) * ideal[i] + std::sin(angle) * along[i];
      const double is = std::clamp(static_cast<double>(Dot(actual, h)), 0.0, 1.0);
      const double was = std::clamp(static_cast<double>(Dot(ideal, h)), 0.0, 1.0);
      worst = std::max<Real>(worst, 255 * std::abs(std::pow(is, n) - std::pow(was, n)));
    }
  }
  return worst;
}

// Calls visit(pixel, normal) for every pixel of the model.
template <typename Visit>
AdaptiveNormalizer VisitPixels(AdaptiveKind kind, const SpanCommand& span, AngleLimit limit,
                               const Visit& visit) {
  AdaptiveNormalizer model(kind, span.normal, span.length, limit);
  AdaptiveSegment segment;
  int pixel = 0;
  while (model.Next(&segment)) {
    for (int i = 0; i < segment.count; ++i) {
      visit(pixel++, AdaptiveNormalizer::Rounded(segment.first));
      for (size_t c = 0; c < 3; ++c) {
        const int64_t next = segment.first[c].raw() + segment.difference[c].raw();
        segment.first[c] = Quantity::Wrap(next);
      }
    }
  }
  return model;
}

inline Real WorstPixel(AdaptiveKind kind, const IdealSpan& ideal, AngleLimit limit, int n) {
  Real worst = 0;
  VisitPixels(kind, ideal.span, limit, [&](int pixel, const PixelNormal& normal) {
    worst = std::max(worst, ErrorOf(normal, ideal.At(pixel), ideal.pole, n));
  });
  return worst;
}

struct Found {
  Real error = -1, turn = 0;
  int length = 0;
};
inline std::string Text(const Found& found) {
  return std::to_string(found.error) + " codes, " + std::to_string(found.turn / kDegree) +
         " degrees, " + std::to_string(found.length) + " pixels";
}

// The worst pixel of spans up to 2048 pixels: random ones, then small moves away from the worst.
inline Found SearchWorst(AdaptiveKind kind, AngleLimit limit, int n, Real most_turn, int rounds,
                         std::mt19937& random) {
  std::normal_distribution<double> move;
  Found worst;
  Plane plane = RandomPlane(random);
  Real size = 0.1L;
  // Angles just below the ones that want another level: the longest parts.
  const Real part = std::acos(1 - std::ldexp(static_cast<Real>(limit.raw()), -30));
  for (int round = 0; round < rounds; ++round) {
    Plane tried = RandomPlane(random);
    Real turn = random() % 2 ? RandomTurnUpTo(most_turn, random)
                             : std::ldexp(part, static_cast<int>(random() % 8)) * 0.9999L;
    int length = std::min(2048, RandomAdaptiveLength(2048, random));
    if (round > rounds / 2) {
      size *= 0.98L;
      for (size_t c = 0; c < 3; ++c)
        tried.start[c] = plane.start[c] + size * static_cast<Real>(move(random));
      tried = PlaneOf(tried.start, plane.side);
      turn = worst.turn * std::exp(size * static_cast<Real>(move(random)));
      length = std::clamp(worst.length + static_cast<int>(random() % 5) - 2, 1, 2048);
    }
    turn = std::min(turn, most_turn);
    const IdealSpan ideal(tried, turn, length, kind == AdaptiveKind::kChord);
    const Real error = WorstPixel(kind, ideal, limit, n);
    if (error > worst.error) worst = {error, turn, length}, plane = tried;
  }
  return worst;
}

}  // namespace shading
