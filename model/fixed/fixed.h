// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cassert>
#include <cmath>
#include <cstdint>

namespace shading {

// Signed fixed point SI.F: 1 sign, I integer and F fraction bits. Twin of sI_F_t in fixed_pkg.sv.
template <int I, int F>
class S {
 public:
  static constexpr int kWidth = 1 + I + F;
  static constexpr int kFraction = F;
  static_assert(kWidth <= 62, "sums of two values must fit int64_t");

  constexpr S() = default;

  static constexpr S FromRaw(int64_t raw) {
    assert(Holds(raw));
    S s;
    s.raw_ = raw;
    return s;
  }
  // Keeps the low bits, as a register of this width does: exact whenever the final value of a chain
  // of sums and products lies in range, whatever the intermediate values did.
  static constexpr S Wrap(int64_t raw) {
    S s;
    s.raw_ = static_cast<int64_t>(static_cast<uint64_t>(raw) << (64 - kWidth)) >> (64 - kWidth);
    return s;
  }
  static S Round(double real) { return FromRaw(std::llround(std::ldexp(real, F))); }
  static constexpr bool Holds(int64_t raw) {
    return raw >= -(int64_t{1} << (I + F)) && raw < (int64_t{1} << (I + F));
  }

  constexpr int64_t raw() const { return raw_; }
  double ToReal() const { return std::ldexp(static_cast<double>(raw_), -F); }
  friend constexpr bool operator==(S a, S b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(S a, S b) { return a.raw_ != b.raw_; }

 private:
  int64_t raw_ = 0;
};

// A register of this width at the top of a 64-bit word, where sums wrap as those of the register
// do.
template <int I, int F>
constexpr uint64_t Align(S<I, F> value) {
  return static_cast<uint64_t>(value.raw()) << (64 - S<I, F>::kWidth);
}
template <typename Fixed>
constexpr Fixed FromAligned(uint64_t aligned) {
  return Fixed::FromRaw(static_cast<int64_t>(aligned) >> (64 - Fixed::kWidth));
}

// Unsigned fixed point UI.F. Twin of uI_F_t in fixed_pkg.sv.
template <int I, int F>
class U {
 public:
  static constexpr int kWidth = I + F;
  static constexpr int kFraction = F;
  static constexpr int64_t kMaxRaw = (int64_t{1} << kWidth) - 1;
  static_assert(kWidth <= 62, "sums of two values must fit int64_t");

  constexpr U() = default;

  static constexpr U FromRaw(int64_t raw) {
    assert(Holds(raw));
    U u;
    u.raw_ = raw;
    return u;
  }
  static constexpr U Saturate(int64_t raw) {
    return FromRaw(raw < 0 ? 0 : raw > kMaxRaw ? kMaxRaw : raw);
  }
  static U Round(double real) { return FromRaw(std::llround(std::ldexp(real, F))); }
  static constexpr bool Holds(int64_t raw) { return raw >= 0 && raw <= kMaxRaw; }

  // Drops the extra fraction bits and clamps to the range of UI.F.
  template <int I2, int F2>
  static constexpr U TruncateSaturate(S<I2, F2> s) {
    static_assert(F2 >= F, "truncation only narrows");
    return Saturate(s.raw() >> (F2 - F));
  }

  constexpr int64_t raw() const { return raw_; }
  double ToReal() const { return std::ldexp(static_cast<double>(raw_), -F); }
  friend constexpr bool operator==(U a, U b) { return a.raw_ == b.raw_; }
  friend constexpr bool operator!=(U a, U b) { return a.raw_ != b.raw_; }

 private:
  int64_t raw_ = 0;
};

}  // namespace shading
