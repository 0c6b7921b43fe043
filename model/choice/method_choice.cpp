// SPDX-License-Identifier: Apache-2.0
#include "model/choice/method_choice.h"

#include <algorithm>

#include "model/choice/method_choice_table.h"

namespace shading {
namespace {

using namespace choice_table;

constexpr int kOneLog = 1 << Log::kFraction;
constexpr int kZeroLog = static_cast<int>(kLogOfZero.raw());
constexpr int64_t kOneTurn = int64_t{1} << Turn::kFraction;
// A highlight of at most T / 8 does not show.
constexpr int kDarkLog = -3 * kOneLog;
// Below n = 4 a highlight has no smooth end: only its steady part is looked at.
constexpr int64_t kSmoothShininess = int64_t{4} << Shininess::kFraction;
constexpr int64_t kSmoothCosine = int64_t{1} << (RangeCosine::kFraction - 1);

int HalfUp(int value) { return (value + 1) >> 1; }

// log2 of the turn, rounded up: log2(1 + m) <= m + 0.0861. Of 0: not used.
int TurnLog(Turn turn) {
  int exponent = 0;
  for (int bit = 0; bit < Turn::kWidth; ++bit) {
    if (turn.raw() >> bit & 1) exponent = bit;
  }
  const int64_t mantissa = turn.raw() << (Turn::kWidth - 1 - exponent);
  const int top = static_cast<int>(mantissa >> (Turn::kWidth - 1 - Log::kFraction)) % kOneLog;
  return (exponent - Turn::kFraction) * kOneLog + top + 4;
}

// -log2 of the highlight's maximum over the triangle, rounded down, 2^-5, 0..1023:
//   n t,  t = 23/16 (1 - cosine) - c l^2,  c = 65/256 for l^2 < 1/4, else 5/16
// with c = 0 for the bound of R.V, which holds for the whole triangle.
int HighlightLog(const LightRange& range, const ChoiceLimit& limit, Lighting lighting) {
  constexpr int64_t kOne = int64_t{1} << RangeCosine::kFraction;
  constexpr int kTurnDrop = Turn::kFraction - RangeCosine::kFraction;
  const int64_t turn = (range.turn.raw() + (1 << kTurnDrop) - 1) >> kTurnDrop;
  const bool small = turn < kOne / 4;
  const int64_t dilation =
      lighting == Lighting::kPhong ? 0 : (turn >> 2) + (turn >> (small ? 8 : 4)) + 2;
  const int64_t below = kOne - range.specular_high.raw();
  const int64_t t = std::clamp<int64_t>((below * 23 >> 4) - dilation, 0, 2 * kOne - 1);
  constexpr int kDrop = RangeCosine::kFraction + Shininess::kFraction - Log::kFraction;
  return static_cast<int>(std::min<int64_t>(limit.shininess.raw() * t >> kDrop, 1023));
}

// An entry by the whole part of the highlight's logarithm. From 4 on 3/4 of the fraction come off:
// the errors fall by more than that.
int At(const Table& table, int highlight) {
  const int whole = std::min(highlight >> Log::kFraction, 15);
  const int fraction = highlight % kOneLog;
  const bool falls = whole >= 4 && whole < 15;
  return table[static_cast<size_t>(whole)] - (falls ? fraction - (fraction >> 2) : 0);
}

// What the bounds are made of, in 2^-5.
struct Terms {
  int turn, diffuse, specular, shininess, highlight;
  bool none, straight, dark, lit, terminator;
};

Terms TermsOf(const LightRange& range, const ChoiceLimit& limit, Lighting lighting) {
  Terms terms;
  terms.none = range.turn.raw() == 0;
  terms.straight = range.turn.raw() <= kOneTurn;
  terms.turn = TurnLog(range.turn);
  terms.diffuse = static_cast<int>(limit.diffuse.raw());
  terms.specular = static_cast<int>(limit.specular.raw());
  terms.shininess = static_cast<int>(limit.shininess_log.raw());
  terms.highlight = terms.straight ? HighlightLog(range, limit, lighting) : 0;
  const bool black = terms.specular == kZeroLog || range.specular_high.raw() <= 0;
  if (black) terms.specular = kZeroLog;
  terms.dark = black || terms.specular - terms.highlight <= kDarkLog;
  const bool above = range.n_dot_l_high.raw() > 0;
  terms.lit = above && terms.diffuse != kZeroLog;
  terms.terminator = terms.lit && range.n_dot_l_low.raw() < 0;
  return terms;
}

}  // namespace

int MethodChoice::LogAdd(int a, int b) {
  const int distance = std::abs(a - b) >> 3;
  return std::max(a, b) + (distance < 32 ? kSum[static_cast<size_t>(distance)] : 0);
}

std::array<MethodChoice::Bound, MethodChoice::kBounds> MethodChoice::BoundsOf(
    const LightRange& range, const ChoiceLimit& limit, Lighting lighting) {
  const Terms t = TermsOf(range, limit, lighting);
  const bool blinn = lighting == Lighting::kBlinn;
  const int q = t.highlight;
  // Logarithms of l, l^2, l^3; of w = sqrt(n) l, w^2, w^3; of sqrt(n) l^3. From n = 4 down the
  // slope of a highlight falls less than sqrt(n).
  const int l1 = HalfUp(t.turn), l2 = t.turn, l3 = HalfUp(3 * t.turn);
  const int few = std::max(0, HalfUp(2 * kOneLog - t.shininess));
  const int w2 = t.turn + t.shininess, w1 = HalfUp(w2), w3 = HalfUp(3 * w2);
  const int root = HalfUp(t.shininess) + l3 + few + (blinn ? 0 : kReflected);
  // The bend of N.H under the peak, n l^4.
  const int wide = std::max(0, w1 + (blinn ? 0 : kReflected) - kWide);
  const int bend = q < kOneLog ? wide : 0;

  const auto diffuse = [&](int log) { return t.lit ? t.diffuse + log : kZeroLog; };
  // A dropped highlight may be missing on one side of an edge.
  const auto specular = [&](int log) {
    return t.dark ? std::max(t.specular - q + kOneLog, kZeroLog) : t.specular + log;
  };
  const bool smooth =
      limit.shininess.raw() >= kSmoothShininess || range.specular_low.raw() >= kSmoothCosine;
  const bool whole =
      t.straight && (t.dark ? limit.below_full_dark : limit.below_full && smooth && blinn);
  return {
      {{Method::kFlat, t.straight && (blinn || t.dark), diffuse(l1 + kFlatDiffuse),
        specular(w1 + few + At(kFlatSpecular, q))},
       {Method::kGouraud, whole, diffuse(t.terminator ? l1 + kGouraudKink : l2 + kGouraudDiffuse),
        specular(w2 + At(kGouraudSpecular, q))},
       {Method::kQuad, whole, diffuse(t.terminator ? l1 + kQuadKink : l3 + kQuadDiffuse),
        specular(w3 + few + At(kQuadSpecular, q))},
       {Method::kQuadCosine, t.straight, std::max(t.diffuse + l3 + kQuadCosineDiffuse, kZeroLog),
        specular(root + bend + At(kCosineSpecular, q))}}};
}

Choice MethodChoice::Of(const LightRange& range, const ChoiceLimit& limit, Lighting lighting) {
  const Terms t = TermsOf(range, limit, lighting);
  Choice choice = {ExactOf(range), t.dark, t.dark && !t.lit, limit.channels};
  const auto bounds = BoundsOf(range, limit, lighting);
  for (const Bound& bound : bounds) {
    const bool good = bound.allowed && LogAdd(bound.diffuse, bound.specular) <= 0;
    if (good || (bound.method == Method::kFlat && (t.none || choice.ambient))) {
      choice.method = bound.method;
      break;
    }
  }
  return choice;
}

}  // namespace shading
