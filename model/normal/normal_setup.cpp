// SPDX-License-Identifier: Apache-2.0
#include "model/normal/normal_setup.h"

#include <algorithm>

#include "model/fixed/wide_integer.h"
#include "model/normal/normal_setup_table.h"

namespace shading {
namespace {

using normal_setup::Segment;

constexpr int kDelta = 38;   // fraction bits of delta, r and g
constexpr int kSquare = 36;  // of psi^2, 1/m^2, u and R/m
constexpr int kKappa = 50;   // of kappa before it gets its exponent
constexpr int kTable = normal_setup::kTableFraction;
constexpr int kOffset = 31;  // of the place t inside a segment
constexpr int64_t kMaxDelta = (int64_t{1} << kDelta) + (int64_t{1} << kOffset) - 1;
constexpr int64_t kOffsetMask = (int64_t{1} << kOffset) - 1;

// value 2^-shift, rounded half up.
constexpr int64_t Round(Int128 value, int shift) {
  return static_cast<int64_t>((value + (Int128{1} << (shift - 1))) >> shift);
}
// a b 2^-shift: the hardware's 40 x 40 multiplier, whose product needs 128-bit integers here.
constexpr int64_t Multiply(int64_t a, int64_t b, int shift) {
  return Round(static_cast<Int128>(a) * b, shift);
}

int64_t Evaluate(const Segment& segment, int64_t t) {
  const int64_t inner = segment.slope + Multiply(segment.curvature, t, kOffset);
  return segment.value + Multiply(inner, t, kOffset);
}

// 1/m = mantissa 2^-exponent, mantissa in (1/2, 1].
struct Reciprocal {
  int64_t mantissa;
  int exponent;
};

Reciprocal ReciprocalOf(int m) {
  const int exponent = 31 - __builtin_clz(static_cast<unsigned>(m));
  const int64_t fraction = (int64_t{m} << (11 - exponent)) & 0x7ff;
  return {Evaluate(normal_setup::kReciprocal[static_cast<size_t>(fraction >> 4)],
                   (fraction & 15) << (kOffset - 4)),
          exponent};
}

// Sums wrap as registers of 64 bits.
template <typename A, typename B>
int64_t Dot(const A& a, const B& b) {
  uint64_t sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    sum += static_cast<uint64_t>(a[i].raw()) * static_cast<uint64_t>(b[i].raw());
  }
  return static_cast<int64_t>(sum);
}

using Chord = std::array<S<2, 30>, 3>;  // Nb - Na

// How much of each end the first difference takes, in S1.38, and kappa with kKappa fraction bits.
struct Turn {
  int64_t r, g, kappa;
};

Turn TurnOf(int64_t delta, const Reciprocal& inverse, int64_t inverse_square) {
  const auto segment = static_cast<size_t>(delta >> kOffset);
  const int64_t t = delta & kOffsetMask;
  const int e = inverse.exponent;
  const int64_t psi_square = Multiply(delta, Evaluate(normal_setup::kAngleSquare[segment], t),
                                      kDelta + kTable - 1 - kSquare);
  const int64_t turn = Evaluate(normal_setup::kAngleOverSine[segment], t);

  const int64_t square = Multiply(psi_square, inverse_square, kSquare);  // phi^2 4^e
  const int64_t u = square >> (2 * e + 1);                               // phi^2, 35 bits
  const auto place = static_cast<size_t>(u >> kOffset);
  const int64_t v = u & kOffsetMask;
  const int64_t kappa =
      Multiply(square, Evaluate(normal_setup::kChord[place], v), kSquare + kTable - kKappa + 2 * e);
  const int64_t slope = Multiply(inverse.mantissa, turn, 2 * kTable - kSquare);
  const int64_t r = Multiply(slope, Evaluate(normal_setup::kSineOverAngle[place], v),
                             kSquare + kTable - kDelta + e);
  const int64_t g = Round((static_cast<Int128>(r) << kDelta) - static_cast<Int128>(delta) * r +
                              (static_cast<Int128>(kappa) << (2 * kDelta - kKappa - 1)),
                          kDelta);
  return {r, g, kappa};
}

Kappa KappaOf(int64_t kappa) {
  constexpr int64_t kOne = int64_t{1} << kKappa;
  Kappa result;
  if (kappa >= kOne) {
    result.mantissa = U<1, 28>::FromRaw(int64_t{1} << 28);
    return result;
  }
  // kappa 4^p <= 1: the highest bit may rise to just below 1, or become 1.
  int p = 0;
  while (p < kMaxKappaExponent && kappa << (2 * p + 2) <= kOne) ++p;
  result.mantissa = U<1, 28>::FromRaw(Round(kappa << (2 * p), kKappa - 28));
  result.exponent = p;
  return result;
}

// kappa of twice the angle, kappa (4 - kappa); up to 4.
int64_t DoubleAngle(int64_t kappa) {
  const int64_t rest = (int64_t{4} << 33) - Round(kappa, kKappa - 33);
  return Multiply(kappa, rest, 33);
}

using Lanes = std::array<QuantitySeed, kMaxLanes>;
using LengthLanes = std::array<LengthSeed, kMaxLanes>;

// The recurrence of slerp_recurrence, seven pixels ahead.
void StartLanes(const Kappa& kappa, Lanes* lanes) {
  std::array<Quantity, 8> s;
  s[0] = (*lanes)[0].first;
  int64_t d = (*lanes)[0].difference.raw();
  const int shift = 18 + 2 * kappa.exponent;
  for (size_t t = 0; t < 7; ++t) {
    s[t + 1] = Quantity::Wrap(s[t].raw() + d);
    const int64_t rounded = S<1, 28>::Wrap((s[t + 1].raw() + (1 << 9)) >> 10).raw();
    const int64_t product = kappa.mantissa.raw() * rounded;
    d = Quantity::Wrap(d - ((product + (int64_t{1} << (shift - 1))) >> shift)).raw();
  }
  for (size_t lane = 0; lane < kMaxLanes; ++lane) {
    (*lanes)[lane] = {s[lane], Quantity::Wrap(s[lane + 4].raw() - s[lane].raw())};
  }
}

void StartLanes(LengthLanes* lanes) {
  std::array<LengthSquare, 8> q;
  const int64_t curvature = (*lanes)[0].curvature.raw();
  q[0] = (*lanes)[0].first;
  int64_t d = (*lanes)[0].difference.raw();
  for (size_t t = 0; t < 7; ++t, d += curvature) q[t + 1] = LengthSquare::Wrap(q[t].raw() + d);
  for (size_t lane = 0; lane < kMaxLanes; ++lane) {
    (*lanes)[lane] = {q[lane], LengthSquare::Wrap(q[lane + 4].raw() - q[lane].raw()),
                      LengthSquare::Wrap(16 * curvature)};
  }
}

// t1 and t2 are 2 Na.(Nb - Na) / m and |Nb - Na|^2 / m^2 with 48 fraction bits.
LengthSeed LengthOf(const SpanNormal& na, const Chord& chord, int64_t chord_square,
                    const Reciprocal& inverse, int64_t inverse_square) {
  const int64_t along = Round(Dot(na, chord), 23);  // S2.37
  const int64_t square = Round(chord_square, 24);   // S3.36
  const int64_t t1 = Multiply(along, inverse.mantissa, 22 + inverse.exponent);
  const int64_t t2 = Multiply(square, inverse_square, 24 + 2 * inverse.exponent);
  return {LengthSquare::Wrap(Round(Dot(na, na), 16)), LengthSquare::Wrap(Round(t1 + t2, 4)),
          LengthSquare::Wrap(Round(t2, 3))};
}

QuantitySeed QuantityOf(int64_t sa, int64_t sb, const Turn& turn) {
  const Int128 sum = static_cast<Int128>(sb) * turn.r - static_cast<Int128>(sa) * turn.g;
  return {Quantity::Wrap(sa), Quantity::Wrap(Round(sum, kDelta))};
}

}  // namespace

void NormalSetup::Seed(const SetupKind& kind, const LightState& light, const SpanCommand& span,
                       int lanes, NormalSeed* seed) {
  *seed = NormalSeed();
  const SpanNormal &na = span.normal[0], &nb = span.normal[1];
  const int m = std::max(1, span.length - 1);
  const Reciprocal inverse = ReciprocalOf(m);
  const int64_t inverse_square = Multiply(inverse.mantissa, inverse.mantissa, 2 * kTable - kSquare);

  Chord chord;
  for (size_t i = 0; i < 3; ++i) chord[i] = S<2, 30>::FromRaw(nb[i].raw() - na[i].raw());
  const int64_t chord_square = Dot(chord, chord);
  // delta = 0 makes G = R = K = S = 1 and kappa = 0: linear spans and spans of one step need no
  // path of their own.
  const bool turns = kind.spherical && m > 1;
  const int64_t delta =
      turns ? std::min(kMaxDelta, Round(static_cast<uint64_t>(chord_square), 23)) : 0;
  const Turn turn = TurnOf(delta, inverse, inverse_square);

  for (size_t i = 0; i < (kind.cosines ? 2 : 3); ++i) {
    const Vector3& direction = i == 0 ? light.light : light.half_or_view;
    const int64_t sa = kind.cosines ? Round(Dot(na, direction), 14) : na[i].raw() * 256;
    const int64_t sb = kind.cosines ? Round(Dot(nb, direction), 14) : nb[i].raw() * 256;
    seed->quantity[i][0] = QuantityOf(Quantity::Wrap(sa).raw(), Quantity::Wrap(sb).raw(), turn);
  }
  if (kind.length) {
    seed->length_square[0] = LengthOf(na, chord, chord_square, inverse, inverse_square);
  }
  seed->kappa = KappaOf(turn.kappa);
  if (lanes == 1) return;

  for (size_t i = 0; i < (kind.cosines ? 2 : 3); ++i) StartLanes(seed->kappa, &seed->quantity[i]);
  if (kind.length) StartLanes(&seed->length_square);
  const int64_t kappa2 = DoubleAngle(turn.kappa);
  seed->step_kappa = {seed->kappa, KappaOf(kappa2)};
  seed->kappa = KappaOf(DoubleAngle(kappa2));
}

}  // namespace shading
