// SPDX-License-Identifier: Apache-2.0
#include "model/normal/normal_setup.h"

#include <algorithm>

#include "model/fixed/wide_integer.h"
#include "model/normal/length_recurrence.h"
#include "model/normal/normal_setup_table.h"
#include "model/normal/slerp_recurrence.h"

namespace shading {
namespace {

constexpr int kDelta = 38;   // fraction bits of delta, r and g
constexpr int kSquare = 36;  // of psi^2, 1/m^2, u and R/m
constexpr int kKappa = 50;   // of kappa before it gets its exponent
constexpr int kTable = normal_setup::kTableFraction;
constexpr int kOffset = 31;  // of the place t inside a segment
constexpr int64_t kMaxDelta = (int64_t{1} << kDelta) + (int64_t{1} << kOffset) - 1;
constexpr int64_t kOffsetMask = (int64_t{1} << kOffset) - 1;

// 1/m = mantissa 2^-exponent, mantissa in (1/2, 1].
struct Reciprocal {
  int64_t mantissa;
  int exponent;
};

Reciprocal ReciprocalOf(int m) {
  const int exponent = 31 - __builtin_clz(static_cast<unsigned>(m));
  const int64_t fraction = (int64_t{m} << (11 - exponent)) & 0x7ff;
  return {normal_setup::Evaluate(normal_setup::kReciprocal[static_cast<size_t>(fraction >> 4)],
                                 (fraction & 15) << (kOffset - 4), kOffset),
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
struct ArcTurn {
  int64_t r, g, kappa;
};

ArcTurn TurnOf(int64_t delta, const Reciprocal& inverse, int64_t inverse_square) {
  const auto segment = static_cast<size_t>(delta >> kOffset);
  const int64_t t = delta & kOffsetMask;
  const int e = inverse.exponent;
  const int64_t psi_square =
      MultiplyRound(delta, normal_setup::Evaluate(normal_setup::kAngleSquare[segment], t, kOffset),
                    kDelta + kTable - 1 - kSquare);
  const int64_t turn = normal_setup::Evaluate(normal_setup::kAngleOverSine[segment], t, kOffset);

  const int64_t square = MultiplyRound(psi_square, inverse_square, kSquare);  // phi^2 4^e
  const int64_t u = square >> (2 * e + 1);                                    // phi^2, 35 bits
  const auto place = static_cast<size_t>(u >> kOffset);
  const int64_t v = u & kOffsetMask;
  const int64_t kappa =
      MultiplyRound(square, normal_setup::Evaluate(normal_setup::kChord[place], v, kOffset),
                    kSquare + kTable - kKappa + 2 * e);
  const int64_t slope = MultiplyRound(inverse.mantissa, turn, 2 * kTable - kSquare);
  const int64_t r =
      MultiplyRound(slope, normal_setup::Evaluate(normal_setup::kSineOverAngle[place], v, kOffset),
                    kSquare + kTable - kDelta + e);
  const int64_t g = RoundShift((static_cast<Int128>(r) << kDelta) - static_cast<Int128>(delta) * r +
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
  // The largest p with kappa 4^p <= 1; the bit that is always set stands for kMaxKappaExponent.
  constexpr int kLeastBits = kKappa - 2 * kMaxKappaExponent;
  const uint64_t below = static_cast<uint64_t>(kappa - (kappa > 0)) | uint64_t{1}
                                                                          << (kLeastBits - 1);
  const int p = (kKappa - 64 + __builtin_clzll(below)) / 2;
  result.mantissa = U<1, 28>::FromRaw(RoundShift(kappa << (2 * p), kKappa - 28));
  result.exponent = p;
  return result;
}

// kappa of twice the angle, kappa (4 - kappa); up to 4.
int64_t DoubleAngle(int64_t kappa) {
  const int64_t rest = (int64_t{4} << 33) - RoundShift(kappa, kKappa - 33);
  return MultiplyRound(kappa, rest, 33);
}

// Lane j starts at pixel j and steps kMaxLanes pixels; `ahead` runs along the first pixels.
template <typename Recurrence, typename Seed>
void StartLanes(Recurrence ahead, std::array<Seed, kMaxLanes>* lanes) {
  using Value = decltype(ahead.value());
  std::array<Value, 2 * kMaxLanes> s;
  for (Value& value : s) {
    value = ahead.value();
    ahead.Step();
  }
  for (size_t lane = 0; lane < kMaxLanes; ++lane) {
    (*lanes)[lane].first = s[lane];
    (*lanes)[lane].difference = Value::Wrap(s[lane + kMaxLanes].raw() - s[lane].raw());
  }
}

// t1 and t2 are 2 Na.(Nb - Na) / m and |Nb - Na|^2 / m^2 with 48 fraction bits.
LengthSeed LengthOf(const SpanNormal& na, const Chord& chord, int64_t chord_square,
                    const Reciprocal& inverse, int64_t inverse_square) {
  const int64_t along = RoundShift(Dot(na, chord), 23);  // S2.37
  const int64_t square = RoundShift(chord_square, 24);   // S3.36
  const int64_t t1 = MultiplyRound(along, inverse.mantissa, 22 + inverse.exponent);
  const int64_t t2 = MultiplyRound(square, inverse_square, 24 + 2 * inverse.exponent);
  return {LengthSquare::Wrap(RoundShift(Dot(na, na), 16)),
          LengthSquare::Wrap(RoundShift(t1 + t2, 4)), LengthSquare::Wrap(RoundShift(t2, 3))};
}

QuantitySeed QuantityOf(int64_t sa, int64_t sb, const ArcTurn& turn) {
  const Int128 sum = static_cast<Int128>(sb) * turn.r - static_cast<Int128>(sa) * turn.g;
  return {Quantity::Wrap(sa), Quantity::Wrap(RoundShift(sum, kDelta))};
}

// Part by part: as a whole it becomes a string instruction, which takes longer to start than the
// parts take in all.
void Clear(NormalSeed* seed) {
  seed->quantity[0] = {};
  seed->quantity[1] = {};
  seed->quantity[2] = {};
  seed->length_square = {};
  seed->kappa = {};
  seed->step_kappa = {};
}

}  // namespace

void NormalSetup::Seed(const SetupKind& kind, const LightState& light, const SpanCommand& span,
                       int lanes, NormalSeed* seed) {
  Clear(seed);
  const SpanNormal &na = span.normal[0], &nb = span.normal[1];
  const int m = std::max(1, span.length - 1);
  const Reciprocal inverse = ReciprocalOf(m);
  const int64_t inverse_square =
      MultiplyRound(inverse.mantissa, inverse.mantissa, 2 * kTable - kSquare);

  Chord chord;
  for (size_t i = 0; i < 3; ++i) chord[i] = S<2, 30>::FromRaw(nb[i].raw() - na[i].raw());
  const int64_t chord_square = Dot(chord, chord);
  // delta = 0 makes G = R = K = S = 1 and kappa = 0: linear spans and spans of one step need no
  // path of their own.
  const bool turns = kind.spherical && m > 1;
  const int64_t delta =
      turns ? std::min(kMaxDelta, RoundShift(static_cast<uint64_t>(chord_square), 23)) : 0;
  const ArcTurn turn = TurnOf(delta, inverse, inverse_square);

  for (size_t i = 0; i < (kind.cosines ? 2 : 3); ++i) {
    const Vector3& direction = i == 0 ? light.light : light.half_or_view;
    const int64_t sa = kind.cosines ? RoundShift(Dot(na, direction), 14) : na[i].raw() * 256;
    const int64_t sb = kind.cosines ? RoundShift(Dot(nb, direction), 14) : nb[i].raw() * 256;
    seed->quantity[i][0] = QuantityOf(Quantity::Wrap(sa).raw(), Quantity::Wrap(sb).raw(), turn);
  }
  if (kind.length) {
    seed->length_square[0] = LengthOf(na, chord, chord_square, inverse, inverse_square);
  }
  seed->kappa = KappaOf(turn.kappa);
  if (lanes == 1) return;

  for (size_t i = 0; i < (kind.cosines ? 2 : 3); ++i) {
    StartLanes(SlerpRecurrence(seed->quantity[i][0], seed->kappa), &seed->quantity[i]);
  }
  if (kind.length) {
    const LengthSeed one = seed->length_square[0];
    StartLanes(LengthRecurrence(one), &seed->length_square);
    for (LengthSeed& lane : seed->length_square) {
      lane.curvature = LengthSquare::Wrap(kMaxLanes * kMaxLanes * one.curvature.raw());
    }
  }
  const int64_t kappa2 = DoubleAngle(turn.kappa);
  seed->step_kappa = {seed->kappa, KappaOf(kappa2)};
  seed->kappa = KappaOf(DoubleAngle(kappa2));
}

}  // namespace shading
