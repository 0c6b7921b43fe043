// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "model/fixed/wide_integer.h"

namespace shading {

// Arithmetic of arcs on the unit sphere: S3.60 in int64_t, products rounded to nearest. Angles are
// in quarter turns. Every function is within a few 2^-60.
inline constexpr int kArcFraction = 60;
inline constexpr int64_t kArcOne = int64_t{1} << kArcFraction;

inline int64_t ArcProduct(int64_t a, int64_t b) { return MultiplyRound(a, b, kArcFraction); }

struct SineCosine {
  int64_t sine, cosine;
};
SineCosine SineCosineOf(int64_t quarter_turns);  // -1..1

// Angle of the point (x, y), both 0..2 and the larger at least 2^-20: 0..1 quarter turns.
int64_t QuarterTurnsOf(int64_t y, int64_t x);

// Square root of a square with 120 fraction bits, <= 4, and its inverse: 1 / sqrt(square) =
// mantissa 2^exponent, mantissa in [1, 2]. All zero for 0.
struct Root {
  int64_t root = 0;
  int64_t inverse = 0;  // S3.60
  int exponent = 0;     // -2..59
};
Root RootOf(Uint128 square);

// a / b in U0.60, 0 <= a <= b, b > 0, rounded to nearest.
int64_t ArcRatio(Uint128 a, Uint128 b);

using ArcVector = std::array<int64_t, 3>;  // S3.60

inline Int128 WideDot(const ArcVector& a, const ArcVector& b) {
  Int128 sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += static_cast<Int128>(a[c]) * b[c];
  return sum;
}
inline ArcVector ScaledBy(const ArcVector& v, const Root& length) {  // v / length
  ArcVector unit;
  for (size_t c = 0; c < 3; ++c) {
    unit[c] = MultiplyRound(v[c], length.inverse, kArcFraction - length.exponent);
  }
  return unit;
}

}  // namespace shading
