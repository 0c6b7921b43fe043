// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace shading {

__extension__ typedef __int128 Int128;
__extension__ typedef unsigned __int128 Uint128;

// floor(n / d), d > 0.
template <typename Int>
constexpr Int FloorDivide(Int n, Int d) {
  const Int quotient = n / d;
  return n % d < 0 ? quotient - 1 : quotient;
}

// Nearest integer to n / d, halves up; d > 0.
constexpr int64_t RoundDivide(Int128 n, int64_t d) {
  return static_cast<int64_t>(FloorDivide<Int128>(2 * n + d, 2 * static_cast<Int128>(d)));
}

// Nearest integer to wide / 2^bits, halves up; bits > 0.
constexpr int64_t RoundShift(Int128 wide, int bits) {
  return static_cast<int64_t>((wide + (Int128{1} << (bits - 1))) >> bits);
}
// a b 2^-bits, rounded likewise: products of more than 64 bits.
constexpr int64_t MultiplyRound(int64_t a, int64_t b, int bits) {
  return RoundShift(static_cast<Int128>(a) * b, bits);
}

// floor(sqrt(square)).
constexpr uint64_t IntegerRoot(Uint128 square) {
  uint64_t root = 0;
  for (int bit = 63; bit >= 0; --bit) {
    const uint64_t trial = root | uint64_t{1} << bit;
    if (static_cast<Uint128>(trial) * trial <= square) root = trial;
  }
  return root;
}

}  // namespace shading
