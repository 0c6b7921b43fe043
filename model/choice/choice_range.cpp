// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "model/choice/method_choice.h"

namespace shading {
namespace {

constexpr int64_t kMostCosine = (int64_t{1} << (RangeCosine::kWidth - 1)) - 1;
constexpr int kCosineDrop = Cosine::kFraction - RangeCosine::kFraction;

RangeCosine CosineFromRaw(int64_t raw) {
  return RangeCosine::FromRaw(std::clamp(raw, -kMostCosine - 1, kMostCosine));
}

// Bounds on a linear function of the normal at the vertices.
struct Range {
  int64_t low, high;
};
template <typename ValueOf>
Range RangeOver(const std::array<LightCosines, 3>& cosines, const ValueOf& value) {
  Range range = {value(cosines[0]), value(cosines[0])};
  for (const LightCosines& at : cosines) {
    range.low = std::min(range.low, value(at));
    range.high = std::max(range.high, value(at));
  }
  return range;
}
RangeCosine Down(int64_t raw) { return CosineFromRaw(raw >> kCosineDrop); }
RangeCosine Up(int64_t raw) { return CosineFromRaw(-(-raw >> kCosineDrop)); }

// Largest |Ni - Nj|^2, rounded up.
Turn TurnOf(const std::array<Vector3, 3>& normals) {
  int64_t most = 0;
  for (size_t i = 0; i < 3; ++i) {
    int64_t square = 0;
    for (size_t axis = 0; axis < 3; ++axis) {
      const int64_t step = normals[i][axis].raw() - normals[(i + 1) % 3][axis].raw();
      square += step * step;
    }
    most = std::max(most, square);
  }
  constexpr int kDrop = 2 * NormalComponent::kFraction - Turn::kFraction;
  return Turn::Saturate(-(-most >> kDrop));
}

// The least and the most of the square of a cosine in `range`, S1.30 -> 2^-40. The most grows where
// the linear normal is short, by 1 / |N|^2 <= 1 + l^2 / 2 for l^2 <= 1.
struct Squares {
  int64_t least, most;
};
Squares SquaresOf(Range range, Turn turn) {
  constexpr int kDrop = 10;
  const int64_t near = range.low > 0 ? range.low : range.high < 0 ? -range.high : 0;
  const int64_t far = std::max(range.high, -range.low);
  const int64_t near_floor = near >> kDrop, far_ceil = -(-far >> kDrop);
  constexpr int kTurnDrop = Turn::kFraction - 14;
  const int64_t growth = (int64_t{1} << 15) + -(-turn.raw() >> kTurnDrop);  // 2^-15
  return {near_floor * near_floor, ((far_ceil * far_ceil >> 15) + 1) * growth};
}

// Bounds on R.V on the whole triangle: with a = N.L and b = N.V,
//   R.V = 2 a b - L.V,  4 a b = (a + b)^2 - (a - b)^2
void SetReflected(const std::array<LightCosines, 3>& cosines, const LightState& light,
                  LightRange* range) {
  constexpr int64_t kOne = int64_t{1} << RangeCosine::kFraction;
  range->specular_low = RangeCosine::FromRaw(-kOne);
  range->specular_high = RangeCosine::FromRaw(kOne);
  if (range->turn.raw() > int64_t{1} << Turn::kFraction) return;
  const auto sum = RangeOver(
      cosines, [](const LightCosines& c) { return c.n_dot_l.raw() + c.n_dot_h_or_v.raw(); });
  const auto difference = RangeOver(
      cosines, [](const LightCosines& c) { return c.n_dot_l.raw() - c.n_dot_h_or_v.raw(); });
  const Squares plus = SquaresOf(sum, range->turn), minus = SquaresOf(difference, range->turn);
  constexpr int kDrop = 11;  // 2^-40 / 2 -> 2^-30
  const int64_t most = -(-(plus.most - minus.least) >> kDrop) - light.l_dot_v.raw();
  const int64_t least = ((plus.least - minus.most) >> kDrop) - light.l_dot_v.raw();
  range->specular_high = RangeCosine::FromRaw(std::min(kOne, Up(most).raw()));
  range->specular_low = RangeCosine::FromRaw(std::max(-kOne, Down(least).raw()));
}

double Most(const Rgb& color) {
  double most = 0;
  for (const Reflectance r : color) most = std::max(most, r.ToReal());
  return most;
}

// log2 in S6.5; the last 2^-12 of a step cover what a C library's log2 may differ by.
constexpr double kSlack = 1.0 / 4096;
Log LogUp(double value) {
  if (value <= 0) return kLogOfZero;
  const double raw = std::ceil(std::log2(value) * (1 << Log::kFraction) + kSlack);
  return Log::FromRaw(static_cast<int64_t>(std::clamp(raw, -1023.0, 2047.0)));
}

}  // namespace

LightRange MethodChoice::RangeOf(const std::array<Vector3, 3>& normals,
                                 const std::array<LightCosines, 3>& cosines,
                                 const LightState& light) {
  LightRange range;
  range.turn = TurnOf(normals);
  const Range lit = RangeOver(cosines, [](const LightCosines& c) { return c.n_dot_l.raw(); });
  range.n_dot_l_low = Down(lit.low);
  range.n_dot_l_high = Up(lit.high);
  if (light.lighting == Lighting::kPhong) {
    SetReflected(cosines, light, &range);
    return range;
  }
  const Range specular =
      RangeOver(cosines, [](const LightCosines& c) { return c.n_dot_h_or_v.raw(); });
  range.specular_low = Down(specular.low);
  range.specular_high = Up(specular.high);
  return range;
}

ChoiceLimit MethodChoice::LimitOf(const Material& material, Tolerance tolerance) {
  ChoiceLimit limit;
  const double codes = tolerance.raw() > 0 ? tolerance.ToReal() : std::ldexp(1, -13);
  const double specular = 255 * Most(material.specular);
  limit.diffuse = LogUp(255 * Most(material.diffuse) / codes);
  // A dropped highlight of T / 8 stays below half a code: see method_choice.
  limit.specular = LogUp(specular / std::min(codes, 4.0));
  limit.shininess_log = LogUp(material.shininess.ToReal());
  limit.shininess = material.shininess;
  limit.below_full = limit.below_full_dark = true;
  constexpr int64_t kOne = int64_t{1} << Reflectance::kFraction;
  for (size_t c = 0; c < kChannels; ++c) {
    const int64_t dark = material.ambient[c].raw() + material.diffuse[c].raw();
    const int64_t full = dark + material.specular[c].raw();
    limit.below_full_dark &= dark <= kOne;
    limit.below_full &= full <= kOne;
    if (full > 0) limit.channels |= static_cast<uint8_t>(1 << c);
  }
  return limit;
}

}  // namespace shading
