// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "model/fixed/fixed.h"
#include "model/triangle_packet.h"

namespace shading {

using Cosine = S<1, 30>;  // N.L, N.H, R.V; the vectors are unit only within 2^-10

// Raw cosines have 32 bits: blocks of pixels hold them so.
constexpr int32_t SaturateCosine(int64_t raw) {
  constexpr int64_t kLimit = int64_t{1} << (Cosine::kWidth - 1);
  return static_cast<int32_t>(raw < -kLimit ? -kLimit : raw >= kLimit ? kLimit - 1 : raw);
}

// The value nearest to raw 2^-(30 + extra), halves up; saturates at -2 and 2 - 2^-30.
constexpr Cosine RoundSaturateCosine(int64_t raw, int extra) {
  const int64_t half = extra > 0 ? int64_t{1} << (extra - 1) : 0;
  return Cosine::FromRaw(SaturateCosine((raw + half) >> extra));
}

// Cosines act on light only in [0, 1]; the raw value then has 31 bits.
constexpr int32_t ClampCosine(int32_t raw) {
  constexpr int32_t kOne = 1 << Cosine::kFraction;
  return raw < 0 ? 0 : raw > kOne ? kOne : raw;
}
constexpr int64_t ClampedRaw(Cosine cosine) {
  return ClampCosine(static_cast<int32_t>(cosine.raw()));
}

// a.b: the 44 fraction bits of the products are rounded once, to nearest.
inline Cosine CosineOf(const Vector3& a, const Vector3& b) {
  constexpr int kExtra = 2 * NormalComponent::kFraction - Cosine::kFraction;
  int64_t sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += a[i].raw() * b[i].raw();
  return RoundSaturateCosine(sum, kExtra);
}

// What a normal contributes to lighting. Both are linear in N, so they may be averaged.
struct LightCosines {
  Cosine n_dot_l;
  Cosine n_dot_h_or_v;  // N.H for Lighting::kBlinn, N.V for kPhong
};

}  // namespace shading
