// SPDX-License-Identifier: Apache-2.0
#include "model/light/mean_cosines.h"

#include <cstdlib>

namespace shading {
namespace {

constexpr int kSquareFraction = 2 * NormalComponent::kFraction;
constexpr int64_t kLeastSquare = int64_t{1} << (kSquareFraction - 10);
constexpr int kRootFraction = 30;

// Root in U4.30, rounded to nearest, of a square in U7.44: one bit of the root per step, from two
// bits of the square, zeros below its fraction.
int64_t Root(int64_t square) {
  constexpr int kTopPair = 50;  // 51 bits of square, in pairs
  constexpr int kBottomPair = kSquareFraction - 2 * kRootFraction;
  int64_t root = 0, remainder = 0;
  for (int pair = kTopPair; pair >= kBottomPair; pair -= 2) {
    remainder = (remainder << 2) | (pair >= 0 ? (square >> pair) & 3 : 0);
    const int64_t trial = (root << 2) | 1;
    root <<= 1;
    if (remainder >= trial) {
      remainder -= trial;
      root |= 1;
    }
  }
  return remainder > root ? root + 1 : root;  // square > (root + 1/2)^2
}

// numerator / root, S3.30 over U4.30 >= 2^-5, rounded to nearest.
Cosine Quotient(int64_t numerator, int64_t root) {
  const int64_t scaled = std::abs(numerator) << kRootFraction;
  int64_t quotient = scaled / root;
  if (2 * (scaled % root) >= root) ++quotient;
  return RoundSaturateCosine(numerator < 0 ? -quotient : quotient, 0);
}

}  // namespace

std::optional<LightCosines> MeanCosines::Normalise(const Sum& sum) {
  int64_t square = 0;
  for (const int64_t component : sum.normal) square += component * component;
  if (square < kLeastSquare) return std::nullopt;
  const int64_t root = Root(square);
  return LightCosines{Quotient(sum.n_dot_l, root), Quotient(sum.n_dot_h_or_v, root)};
}

}  // namespace shading
