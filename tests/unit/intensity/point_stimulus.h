// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "tests/unit/intensity/seed_stimulus.h"

namespace shading {

// Points whose spans of `length` pixels stay in S12.0. Either six unrelated coefficients, whose
// sums wrap, or a surface that moves through the codes within the span.
inline SurfacePoint RandomPoint(int length, std::mt19937& random) {
  const int most = kMaxScreen - 1;
  const auto edge = [&](int low, int high) {
    switch (random() % 4) {
      case 0: return low;
      case 1: return high;
      default: return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    }
  };
  const int x = edge(-most, most - (length - 1)), y = edge(-most, most);
  const auto any = [&] { return RandomAcc(random); };
  if (random() % 2) return {{any(), any(), any(), any(), any(), any()}, x, y};
  const double width = std::max(1, std::max(std::abs(x), std::abs(x + length - 1)));
  const double height = std::max(1, std::abs(y));
  const auto term = [&](double divisor) {
    std::uniform_real_distribution<double> amplitude(-100, 100);
    return IntensityAcc::Round(amplitude(random) / divisor);
  };
  return {{term(width * width), term(height * height), term(width * height), term(width),
           term(height), IntensityAcc::FromRaw(128 * kOneCode)},
          x,
          y};
}

// 2^26 I(x, y) in integers, without a register that could wrap.
inline Int128 PolynomialAt(const Surface& s, int x, int y) {
  const auto wide = [](IntensityAcc value) { return static_cast<Int128>(value.raw()); };
  return wide(s.a) * x * x + wide(s.b) * y * y + wide(s.c) * x * y + wide(s.d) * x + wide(s.e) * y +
         wide(s.f);
}

// Marches spans through RTL and model of one lane. The pattern says in which cycles the next pixel
// is wanted; in the others the code must hold. The point carries noise except when it is loaded,
// and the step pin does so then.
template <typename Model, typename Dut>
void ExpectSamePointCodes(const FlowPattern& steps, int spans, int lane, int lanes) {
  std::mt19937 random(2);
  Dut rtl;
  int64_t cycle = 0;
  for (int span = 0; span < spans; ++span) {
    const int length = RandomLength(random);
    const SurfacePoint point = RandomPoint(length, random);
    const SurfacePoint noise = RandomPoint(1, random);
    Model model(point, lane, lanes);
    rtl.Cycle(true, random() % 2, point);
    for (int t = lane; t < length; t += lanes) {
      ASSERT_EQ(rtl.code(), model.code()) << "span " << span << " pixel " << t;
      for (; !steps.At(cycle); ++cycle) {
        rtl.Cycle(false, false, noise);
        ASSERT_EQ(rtl.code(), model.code()) << "held: span " << span << " pixel " << t;
      }
      rtl.Cycle(false, true, noise);
      model.Step();
      ++cycle;
    }
  }
}

// Model against the polynomial in wide integers, every lane of one and of four.
template <typename Model>
void ExpectPolynomialCodes(int spans) {
  std::mt19937 random(3);
  for (int span = 0; span < spans; ++span) {
    const int length = RandomLength(random), lanes = random() % 2 ? 4 : 1;
    const int lane = static_cast<int>(random() % static_cast<unsigned>(lanes));
    const SurfacePoint point = RandomPoint(length, random);
    Model model(point, lane, lanes);
    for (int t = lane; t < length; t += lanes, model.Step()) {
      ASSERT_EQ(model.code(), CodeOf(PolynomialAt(point.surface, point.x + t, point.y)))
          << "span " << span << " pixel " << t;
    }
  }
}

// A real surface, and its coefficients rounded to nearest.
struct RealSurface {
  std::array<double, 6> coefficient;  // A to F, codes

  long double At(int x, int y) const {
    const auto& c = coefficient;
    const long double wide_x = x, wide_y = y;
    return c[0] * wide_x * wide_x + c[1] * wide_y * wide_y + c[2] * wide_x * wide_y +
           c[3] * wide_x + c[4] * wide_y + c[5];
  }
  Surface Rounded() const {
    const auto round = [&](size_t i) { return IntensityAcc::Round(coefficient[i]); };
    return {round(0), round(1), round(2), round(3), round(4), round(5)};
  }
};

inline constexpr int kBoundedOffset = 2047;  // |x|, |y| for which the contracts state their error

// (x^2 + |x y| + y^2 + |x| + |y| + 1) 2^-27 codes.
inline double PointBound(int x, int y) {
  const double wide_x = std::abs(x), wide_y = std::abs(y);
  return std::ldexp(wide_x * wide_x + wide_x * wide_y + wide_y * wide_y + wide_x + wide_y + 1, -27);
}

// Distance of the integer polynomial from the real one, in codes. The model is held to the integer
// polynomial, so this is its error before the code is rounded.
inline double PointDrift(const RealSurface& real, int x, int y) {
  const Int128 integer = PolynomialAt(real.Rounded(), x, y);
  const long double distance = static_cast<long double>(integer) - std::ldexp(real.At(x, y), 26);
  return static_cast<double>(std::ldexp(std::abs(distance), -26));
}

// Every coefficient `off` 2^-26 codes from its rounded value, towards `sign`. Products of 26
// fraction bits and 24 bits of x^2 are exact in long double.
inline RealSurface NearlyTied(const std::array<int64_t, 6>& raw, const std::array<int, 6>& sign,
                              double off) {
  RealSurface real;
  for (size_t i = 0; i < raw.size(); ++i) {
    real.coefficient[i] = std::ldexp(static_cast<double>(raw[i]) + sign[i] * off, -26);
  }
  return real;
}

// Largest drift over the corners of |x|, |y| <= kBoundedOffset, found by turning one coefficient's
// rounding error after the other in the direction that adds, from random surfaces in the codes.
template <typename Model>
double WorstPointDrift(int surfaces) {
  std::mt19937 random(4);
  const double off = 0.5 - std::ldexp(1, -10);
  double worst = 0;
  for (int i = 0; i < surfaces; ++i) {
    const int x = random() % 2 ? kBoundedOffset : -kBoundedOffset;
    const int y = random() % 2 ? kBoundedOffset : -kBoundedOffset;
    std::array<int64_t, 6> raw = {};
    std::array<int, 6> sign = {};
    const std::array<int, 6> shift = {22, 22, 22, 11, 11, 0};  // about x^2, y^2, x y, x, y, 1
    for (size_t k = 0; k < raw.size(); ++k) {
      raw[k] = static_cast<int64_t>(random() % (40 * kOneCode)) >> shift[k];
      sign[k] = random() % 2 ? 1 : -1;
    }
    double found = PointDrift(NearlyTied(raw, sign, off), x, y);
    for (int& turned : sign) {
      turned = -turned;
      const double drift = PointDrift(NearlyTied(raw, sign, off), x, y);
      if (drift < found) turned = -turned;
      found = std::max(found, drift);
    }
    const RealSurface real = NearlyTied(raw, sign, off);
    const Model model({real.Rounded(), x, y});
    const double ideal = std::clamp(static_cast<double>(real.At(x, y)) - 0.5, 0.0, 255.0);
    EXPECT_LE(std::abs(model.code() - ideal), 0.5 + found + 1e-9) << "surface " << i;
    worst = std::max(worst, found);
  }
  return worst;
}

}  // namespace shading
