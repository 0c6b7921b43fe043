// SPDX-License-Identifier: Apache-2.0
#include "model/normal/adaptive_normalizer.h"

#include <algorithm>
#include <cstddef>

#include "model/fixed/wide_integer.h"
#include "model/normal/adaptive_normalizer_table.h"
#include "model/normal/phong_direct.h"
#include "model/normal/pixel_normal.h"

namespace shading {
namespace {

constexpr int kAngle = adaptive_normalizer::kFraction;   // fraction bits of x and 1/z
constexpr int kOffset = kAngle - 6;                      // of the place in a table's segment
constexpr int kInverse = 30;                             // of 2^e / width
constexpr int kPlace = AdaptiveNormalizer::kMostLevels;  // of places along the span
constexpr int64_t kOnePixel = int64_t{1} << kPlace;
constexpr int64_t kMostAngle = int64_t{3} << (kAngle - 1);  // 120 degrees
constexpr int kNodeShift = SpanNormalComponent::kFraction - PixelNormalComponent::kFraction;

int64_t CeilingLog2(int64_t value) {
  int64_t log = 0;
  while (int64_t{1} << log < value) ++log;
  return log;
}

// 2^e / m with e = floor(log2 m), U1.30.
int64_t InverseOf(int64_t m, int exponent) {
  constexpr int kBits = 31;
  const int64_t fraction = (m << (11 - exponent)) & 0x7ff;
  return RoundShift(
      normal_setup::Evaluate(normal_setup::kReciprocal[static_cast<size_t>(fraction >> 4)],
                             (fraction & 15) << (kBits - 4), kBits),
      normal_setup::kTableFraction - kInverse);
}

int64_t Look(const adaptive_normalizer::Table<adaptive_normalizer::kSegments>& table, int64_t x) {
  return normal_setup::Evaluate(table[static_cast<size_t>(x >> kOffset)],
                                x & ((int64_t{1} << kOffset) - 1), kOffset);
}

int64_t Difference(const SpanNormal& a, const SpanNormal& b, size_t i) {
  return b[i].raw() - a[i].raw();
}

// 1 - cos of the angle between two unit normals: half their squared distance.
int64_t AngleOf(const SpanNormal& a, const SpanNormal& b) {
  uint64_t sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const auto d = static_cast<uint64_t>(Difference(a, b, i));
    sum += d * d;
  }
  return std::min(kMostAngle, RoundShift(sum, 2 * SpanNormalComponent::kFraction + 1 - kAngle));
}

SpanNormal Normalised(const std::array<Quantity, 3>& normal) {
  const PixelNormal unit = PhongDirect::Of(normal);
  SpanNormal result;
  for (size_t i = 0; i < 3; ++i) {
    result[i] = SpanNormalComponent::FromRaw(unit[i].raw() * (1 << kNodeShift));
  }
  return result;
}

}  // namespace

AdaptiveNormalizer::AdaptiveNormalizer(AdaptiveKind kind, const std::array<SpanNormal, 2>& normal,
                                       int length, AngleLimit limit)
    : kind_(kind), end_(normal), last_pixel_(length - 1), limit_(limit.raw()) {
  width_ = last_pixel_;
  const int64_t m = std::max<int64_t>(1, last_pixel_);
  exponent_ = 63 - __builtin_clzll(static_cast<uint64_t>(m));
  inverse_ = InverseOf(m, exponent_);
  if (kind_ == AdaptiveKind::kExtended) {
    end_[1] = ExtendedEnd();
    exponent_ = static_cast<int>(CeilingLog2(m));
    width_ = int64_t{1} << exponent_;
    inverse_ = int64_t{1} << kInverse;
    setup_cycles_ += kExtend;
    ++normalisations_;
  }
  if (kind_ != AdaptiveKind::kChord) {
    SetUp(limit);
  } else {
    steps_ = kChordEnds;
    normalisations_ = 2;
  }
  left_ = kind_ == AdaptiveKind::kChord ? ChordPoint(0) : end_[0];
  top() = {kind_ == AdaptiveKind::kChord ? ChordPoint(kOnePixel) : end_[1], 0};
}

void AdaptiveNormalizer::SetUp(AngleLimit limit) {
  int64_t x = AngleOf(end_[0], end_[1]);
  for (levels_ = 0; levels_ < kMostLevels && x > limit.raw() << (kAngle - AngleLimit::kFraction);
       ++levels_) {
    divisor_[static_cast<size_t>(levels_)] = Look(adaptive_normalizer::kDivisor, x);
    x = Look(adaptive_normalizer::kHalfAngle, x);
  }
  setup_cycles_ += kLevelSetup * levels_;
}

// (Na + (Nb - Na) 2^k / m) / 2, normalised; 2^k is the power of 2 next above m, or m.
SpanNormal AdaptiveNormalizer::ExtendedEnd() const {
  const int more = (int64_t{1} << exponent_) < last_pixel_;
  constexpr int kShift = SpanNormalComponent::kFraction + kInverse + 1 - Quantity::kFraction;
  std::array<Quantity, 3> half;
  for (size_t i = 0; i < 3; ++i) {
    half[i] =
        Quantity::Wrap(end_[0][i].raw() * (1 << 7) +
                       MultiplyRound(Difference(end_[0], end_[1], i), inverse_, kShift - more));
  }
  return Normalised(half);
}

// Place 0 .. 1 on the chord, with kPlace fraction bits.
SpanNormal AdaptiveNormalizer::ChordPoint(int64_t place) const {
  std::array<Quantity, 3> point;
  for (size_t i = 0; i < 3; ++i) {
    constexpr int kDrop = kPlace + SpanNormalComponent::kFraction - Quantity::kFraction;
    point[i] = Quantity::Wrap(end_[0][i].raw() * (1 << 8) +
                              RoundShift(Difference(end_[0], end_[1], i) * place, kDrop));
  }
  return Normalised(point);
}

// |N_g - N_p|^2 / 2 <= limit, for nodes on the chord, which have 24 fraction bits.
bool AdaptiveNormalizer::Small() const {
  uint64_t sum = 0;
  for (size_t i = 0; i < 3; ++i) {
    const auto d = static_cast<uint64_t>(Difference(left_, top().normal, i) >> kNodeShift);
    sum += d * d;
  }
  return sum <= static_cast<uint64_t>(limit_) << (2 * 24 + 1 - AngleLimit::kFraction);
}

// The normal in the middle of the part at hand.
SpanNormal AdaptiveNormalizer::Middle(int level) {
  ++normalisations_;
  if (kind_ == AdaptiveKind::kChord) {
    // place_ = a width 2^(kPlace - kMostLevels): a is the part's start on the chord.
    const int64_t start = width_ == 0 ? 0 : place_ / width_;
    return ChordPoint(start + (kOnePixel >> (level + 1)));
  }
  SpanNormal middle;
  for (size_t i = 0; i < 3; ++i) {
    middle[i] = SpanNormalComponent::Wrap(
        MultiplyRound(left_[i].raw() + top().normal[i].raw(), Divisor(level), kAngle));
  }
  return middle;
}

// Whether the part at hand is divided: a pixel lies inside and the angle is too large. The last
// pixel is never before `next`: a part that contains it is the last.
bool AdaptiveNormalizer::Divides() {
  const int64_t next = (place_ >> kPlace) + 1;  // first pixel behind its start
  if (level_ == levels_ || next << kPlace >= right()) return false;
  if (kind_ != AdaptiveKind::kChord) return true;
  steps_ += kChordTest;
  if (Small()) return false;
  steps_ += kChordSplit - 1;
  return true;
}

void AdaptiveNormalizer::Fill(AdaptiveSegment* segment) const {
  const int64_t first = (place_ + kOnePixel - 1) >> kPlace;
  const int64_t offset = (first << kPlace) - place_;
  constexpr int kShift = SpanNormalComponent::kFraction + kInverse - Quantity::kFraction;
  for (size_t i = 0; i < 3; ++i) {
    const Quantity difference = Quantity::Wrap(
        MultiplyRound(Difference(left_, top().normal, i), inverse_, kShift + exponent_ - level_));
    segment->difference[i] = difference;
    segment->first[i] =
        Quantity::Wrap(left_[i].raw() * (1 << 8) + RoundShift(difference.raw() * offset, kPlace));
  }
}

// To the part behind the one at hand.
void AdaptiveNormalizer::Pass() {
  place_ = right();
  left_ = top().normal;
  level_ = top().level;
  --depth_;
}

bool AdaptiveNormalizer::Next(AdaptiveSegment* segment) {
  if (done_) return false;
  while (true) {
    ++steps_;
    if (Divides()) {
      const SpanNormal middle = Middle(level_);
      ++level_;
      ++depth_;
      top() = {middle, level_};
      continue;
    }
    const int64_t first = (place_ + kOnePixel - 1) >> kPlace;
    const int64_t behind = (right() + kOnePixel - 1) >> kPlace;
    segment->last = right() >= last_pixel_ << kPlace;
    segment->count = static_cast<int>((segment->last ? last_pixel_ + 1 : behind) - first);
    if (segment->count == 0) {
      Pass();
      continue;
    }
    Fill(segment);
    segment->steps = steps_;
    steps_ = 0;
    done_ = segment->last;
    if (!done_) Pass();
    return true;
  }
}

// 2 t (2 s - t) / s^2 with s = 255 2^12.
AngleLimit AdaptiveNormalizer::DiffuseLimit(Tolerance tolerance) {
  constexpr int64_t kFullScale = int64_t{255} << Tolerance::kFraction;
  const int64_t t = tolerance.raw();
  return AngleLimit::FromRaw((2 * t * (2 * kFullScale - t) << 6) / (255 * 255));
}

// 4 t / (s n), or t / (s n), with n of 7 fraction bits.
AngleLimit AdaptiveNormalizer::SpecularLimit(Tolerance tolerance, Shininess shininess,
                                             Lighting lighting) {
  constexpr int64_t kOne = int64_t{1} << Shininess::kFraction;
  if (lighting == Lighting::kPhong) {
    return AngleLimit::FromRaw((tolerance.raw() << 25) / (255 * shininess.raw()));
  }
  if (shininess.raw() == kOne) return DiffuseLimit(tolerance);
  return AngleLimit::FromRaw((tolerance.raw() << 27) / (255 * std::max(2 * kOne, shininess.raw())));
}

AngleLimit AdaptiveNormalizer::LimitOf(Tolerance tolerance, Shininess shininess, bool specular,
                                       Lighting lighting) {
  const AngleLimit diffuse = DiffuseLimit(tolerance);
  if (!specular) return diffuse;
  return AngleLimit::FromRaw(
      std::min(diffuse.raw(), SpecularLimit(tolerance, shininess, lighting).raw()));
}

PixelNormal AdaptiveNormalizer::Rounded(const std::array<Quantity, 3>& normal) {
  return {RoundPixelNormal(normal[0]), RoundPixelNormal(normal[1]), RoundPixelNormal(normal[2])};
}

}  // namespace shading
