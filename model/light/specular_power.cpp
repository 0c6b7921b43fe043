// SPDX-License-Identifier: Apache-2.0
#include "model/light/specular_power.h"

namespace shading {
namespace {

constexpr int kFraction = SpecularPower::kFraction;
constexpr int64_t kOne = int64_t{1} << kFraction;

// -log2 x in U5.46, for x in U1.30, 2^-30..1.
int64_t NegativeLog2(int64_t x) {
  int64_t mantissa = x << (kFraction - Cosine::kFraction);
  int64_t exponent = 0;
  for (; mantissa < kOne; mantissa <<= 1) exponent += kOne;

  // The largest product of factors that does not exceed the mantissa.
  int64_t product = kOne, log = 0;
  for (int k = 1; k <= SpecularPower::kSteps; ++k) {
    const int64_t next = product + (product >> k);
    if (next <= mantissa) {
      product = next;
      log += SpecularPower::kLog2[static_cast<size_t>(k - 1)];
    }
  }
  return exponent - log;
}

// 2^g in U1.46, for g in U0.46.
int64_t Exp2(int64_t g) {
  int64_t product = kOne;
  for (int k = 1; k <= SpecularPower::kSteps; ++k) {
    const int64_t step = SpecularPower::kLog2[static_cast<size_t>(k - 1)];
    if (g >= step) {
      g -= step;
      product += product >> k;
    }
  }
  return product;
}

// y n in U14.46, truncated, for y in U5.46. Integer and fraction of n apart: 60 bits hold it all.
int64_t TimesShininess(int64_t y, Shininess n) {
  constexpr int64_t kMask = (int64_t{1} << Shininess::kFraction) - 1;
  return y * (n.raw() >> Shininess::kFraction) + ((y * (n.raw() & kMask)) >> Shininess::kFraction);
}

}  // namespace

SpecularFactor SpecularPower::Of(Cosine x, Shininess n) {
  const int64_t clamped = ClampedRaw(x);
  if (clamped == 0) return SpecularFactor();

  // 2^-t = 2^-octaves 2^g with g in [0, 1).
  const int64_t t = TimesShininess(NegativeLog2(clamped), n);
  const int64_t octaves = (t + kOne - 1) >> kFraction;
  if (octaves > SpecularFactor::kFraction + 1) return SpecularFactor();
  const int64_t power = Exp2((octaves << kFraction) - t);

  const int shift = kFraction - SpecularFactor::kFraction + static_cast<int>(octaves);
  return SpecularFactor::FromRaw((power + (int64_t{1} << (shift - 1))) >> shift);
}

}  // namespace shading
