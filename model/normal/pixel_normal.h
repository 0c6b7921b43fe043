// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/dot_product.h"
#include "model/shading_types.h"

namespace shading {

// S1.38 -> S1.24: rounds halves up, saturates.
constexpr PixelNormalComponent RoundPixelNormal(Quantity value) {
  constexpr int kExtra = Quantity::kFraction - PixelNormalComponent::kFraction;
  constexpr int64_t kMax = (int64_t{1} << (PixelNormalComponent::kWidth - 1)) - 1;
  const int64_t rounded = (value.raw() + (int64_t{1} << (kExtra - 1))) >> kExtra;
  return PixelNormalComponent::FromRaw(rounded > kMax ? kMax : rounded);
}

// S1.38 -> S1.30: rounds halves up, saturates.
constexpr Cosine RoundQuantity(Quantity value) {
  return RoundSaturateCosine(value.raw(), Quantity::kFraction - Cosine::kFraction);
}

inline LightCosines CosinesOf(const PixelNormal& normal, const LightState& light) {
  return {DotProduct::Of(normal, light.light), DotProduct::Of(normal, light.half_or_view)};
}

}  // namespace shading
