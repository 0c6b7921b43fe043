// SPDX-License-Identifier: Apache-2.0
#include "model/normal/slerp_direct_setup.h"

#include <algorithm>

#include "model/fixed/wide_integer.h"
#include "model/normal/reciprocal_sqrt.h"
#include "model/normal/slerp_direct_setup_table.h"

namespace shading {
namespace {

constexpr int kTable = normal_setup::kTableFraction;
constexpr int kOffset = 28;  // fraction bits of the place t inside a segment of 1/64
constexpr int64_t kMaxPlace = (int64_t{slerp_direct_setup::kSegments} << kOffset) - 1;
constexpr int64_t kQuarterTurn = 0x1921fb54443;  // radians, U1.40

// Angles of arcs that are straight: 2^-25 when every |d| < 2^-24, 2^-20 when every |d| < 2^-19.
constexpr int kSmallestAngle = 25, kSmallAngle = 20;

constexpr int64_t Clamp(int64_t value, int bits) {
  return std::clamp(value, -(int64_t{1} << (bits - 1)), (int64_t{1} << (bits - 1)) - 1);
}

// What turns a seed of any amplitude into an arc.
struct ArcTurn {
  Angle step;
  int64_t inverse;  // 1/sin(phi) = inverse 2^exponent, 36 fraction bits
  int exponent;
};

ArcTurn TurnOf(const Kappa& kappa) {
  const int64_t mantissa = kappa.mantissa.raw();
  const ReciprocalRoot root = ReciprocalSqrt::Of(SquaredLength::FromRaw(mantissa << 16));
  const int exponent = kappa.exponent + root.exponent;
  const int64_t x = mantissa << (2 * root.exponent);  // U2.28
  const int64_t r = root.mantissa.raw();              // 1/sqrt(x), 24 fraction bits
  const int64_t a = MultiplyRound(x, r, 28 + 24 - 38);
  const int64_t h =
      RoundShift((Int128{1} << 62) - static_cast<Int128>(a) * r, 62 - 46);  // 1 - x r^2
  const int64_t r1 = (r << 12) + MultiplyRound(r, h, 24 + 46 + 1 - 36);     // U1.36
  const int64_t s = MultiplyRound(x, r1, 28 + 36 - 36);                     // U2.36

  const int64_t place = std::min(kMaxPlace, (mantissa << 6) >> (2 * kappa.exponent));
  const auto segment = static_cast<size_t>(place >> kOffset);
  const int64_t t = place & ((int64_t{1} << kOffset) - 1);
  const int64_t angle =
      normal_setup::Evaluate(slerp_direct_setup::kAngleOverChord[segment], t, kOffset);
  const int64_t sine =
      normal_setup::Evaluate(slerp_direct_setup::kChordOverSine[segment], t, kOffset);
  const int64_t step = MultiplyRound(s, angle, 36 + kTable - 40 + exponent);
  return {Angle::FromRaw(step & Angle::kMaxRaw), MultiplyRound(r1, sine, 36 + kTable - 36),
          exponent};
}

// kappa = 0.
SpanArc StraightArc(const std::array<QuantitySeed, 3>& seed, SpanArc arc) {
  // d 2^k fits S1.38.
  const auto fits = [&seed](int k) {
    return std::all_of(seed.begin(), seed.end(), [k](const QuantitySeed& s) {
      return Clamp(s.difference.raw(), Quantity::kWidth - k) == s.difference.raw();
    });
  };
  const int k = fits(kSmallestAngle) ? kSmallestAngle : fits(kSmallAngle) ? kSmallAngle : 0;
  arc.step = Angle::FromRaw(k == 0 ? kQuarterTurn : int64_t{1} << (Angle::kFraction - k));
  for (size_t i = 0; i < 3; ++i) {
    const int64_t d = seed[i].difference.raw();
    const int64_t end = Clamp(RoundShift(arc.start[i].raw() * 256 + d, 8), 32);
    arc.side[i] = SpanNormalComponent::FromRaw(k == 0 ? end : d * (int64_t{1} << k) >> 8);
  }
  return arc;
}

}  // namespace

SpanArc SlerpDirectSetup::Of(const std::array<QuantitySeed, 3>& seed, const Kappa& kappa) {
  SpanArc arc;
  for (size_t i = 0; i < 3; ++i) {
    arc.start[i] = SpanNormalComponent::FromRaw(seed[i].first.raw() >> 8);
  }
  if (kappa.mantissa.raw() == 0) return StraightArc(seed, arc);

  const ArcTurn turn = TurnOf(kappa);
  arc.step = turn.step;
  for (size_t i = 0; i < 3; ++i) {
    const int64_t bend =
        MultiplyRound(arc.start[i].raw(), kappa.mantissa.raw(), 19 + 2 * kappa.exponent);
    const int64_t v = seed[i].difference.raw() * 4 + bend;  // Nk sin(phi), S2.40
    const auto raised = static_cast<Int128>(v) << turn.exponent >> 6;
    const auto u = static_cast<int64_t>(
        std::clamp(raised, -(Int128{1} << 36), (Int128{1} << 36) - 1));  // S2.34
    arc.side[i] = SpanNormalComponent::FromRaw(Clamp(MultiplyRound(u, turn.inverse, 40), 32));
  }
  return arc;
}

}  // namespace shading
