// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/adaptive_error.h"

#include <algorithm>

#include "model/normal/adaptive_normalizer.h"
#include "sim/stress/span_arcs.h"

namespace shading::stress {
namespace {

struct Case {
  SpanCommand span;
  Real turn;
  Vector pole;
  double shininess;  // 1: diffuse only
  Tolerance tolerance;
  AngleLimit limit;
};

Case CaseOf(const Genes& g) {
  Case c;
  c.tolerance = Tolerance::Round(g[6] < 0.5 ? 0 : Geometric(1.0 / 16, 8, 2 * g[6] - 1));
  c.shininess = g[5] < 0.125 ? 1 : Geometric(1, 256, (g[5] - 0.125) / 0.875);
  const Shininess shininess = Shininess::Round(c.shininess);
  c.shininess = shininess.ToReal();
  c.limit = AdaptiveNormalizer::LimitOf(c.tolerance, shininess, c.shininess > 1);
  const Real most = kPi / 2;
  const Real part = std::acos(1 - std::ldexp(static_cast<Real>(c.limit.raw()), -30));
  const auto octave = static_cast<int>(16 * (g[3] - 0.5));
  const Real asked = g[3] < 0.5 ? static_cast<Real>(Geometric(0.01, 90, 2 * g[3])) * kPi / 180
                                : std::ldexp(part, octave) * 0.99999L;
  const GreatArc arc = GreatArc::Of(g);
  c.span = SpanOf(arc, std::min(asked, most * 0.999999L), PixelsOf(g[4], 4096));
  c.turn = TurnBetween(c.span);
  c.pole = Cross(arc.start, arc.side);
  return c;
}

// |error| of a full-scale component in codes: N.L with the worst L; (N.H)^n with H in the plane of
// the span, at and beside the normal.
Real CodesOff(const Vector& actual, const Vector& ideal, const Vector& pole, double n) {
  const Vector off = {actual[0] - ideal[0], actual[1] - ideal[1], actual[2] - ideal[2]};
  if (n == 1) return 255 * std::sqrt(Dot(off, off));
  const Vector along = Cross(pole, ideal);
  Real worst = 0;
  for (const double side : {-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5}) {
    const Real angle = static_cast<Real>(side / std::sqrt(n));
    Vector h;
    for (size_t i = 0; i < 3; ++i) h[i] = std::cos(angle) * ideal[i] + std::sin(angle) * along[i];
    const double is = std::clamp(static_cast<double>(Dot(actual, h)), 0.0, 1.0);
    const double was = std::clamp(static_cast<double>(Dot(ideal, h)), 0.0, 1.0);
    Raise(&worst, 255 * std::abs(std::pow(is, n) - std::pow(was, n)));
  }
  return worst;
}

Vector Shown(const AdaptiveSegment& s, int i, int narrow) {
  std::array<Quantity, 3> at;
  for (size_t c = 0; c < 3; ++c)
    at[c] = Quantity::Wrap(s.first[c].raw() + i * s.difference[c].raw());
  const PixelNormal normal = AdaptiveNormalizer::Rounded(at);
  Vector v;
  for (size_t c = 0; c < 3; ++c)
    v[c] = std::ldexp(static_cast<Real>(Narrowed(normal[c].raw(), narrow)), -24);
  return v;
}

}  // namespace

double AdaptiveExcess(const Genes& genes, int narrow) {
  const Case c = CaseOf(genes);
  AdaptiveNormalizer unit(AdaptiveKind::kSphere, c.span.normal, c.span.length, c.limit);
  // First, middle and last pixel of a segment; of many short segments every tenth.
  Real worst = 0;
  AdaptiveSegment segment;
  for (int pixel = 0, k = 0; unit.Next(&segment); pixel += segment.count, ++k) {
    if (segment.count < 8 && k % 10 != 0) continue;
    for (const int i : {0, segment.count / 2, segment.count - 1}) {
      Raise(&worst, CodesOff(Shown(segment, i, narrow), SlerpAt(c.span, c.turn, pixel + i), c.pole,
                             c.shininess));
    }
  }
  return static_cast<double>(worst) - c.tolerance.ToReal();
}

}  // namespace shading::stress
