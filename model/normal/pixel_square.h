// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/normal/normal_types.h"

namespace shading {

// S1.38 -> S1.30, truncated.
constexpr int64_t ShortenedRaw(Quantity component) {
  return component.raw() >> (Quantity::kFraction - SpanNormalComponent::kFraction);
}

// M.M in U4.60 of the components in S1.30: below 12 for any input.
inline uint64_t SquareSum(const std::array<Quantity, 3>& normal) {
  uint64_t sum = 0;
  for (const Quantity component : normal) {
    const int64_t shortened = ShortenedRaw(component);
    sum += static_cast<uint64_t>(shortened * shortened);
  }
  return sum;
}

}  // namespace shading
