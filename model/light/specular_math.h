// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>

#include "model/light/light_types.h"
#include "model/light/quadratic_table.h"

namespace shading {

// The steps of a power 2^-(n y), y = -log2 x, on raw numbers: BlinnSpecular takes them for one
// pixel, PixelLightBlock for many. 32 bits, no branch and no builtin, so that a loop over pixels
// runs in vector registers; what is looked up is an argument, for vector registers look up badly.
class SpecularMath {
 public:
  static constexpr int kLogPlace = 22, kExpPlace = 18;  // bits of u and g inside a segment
  static constexpr auto kLogSegments = Placed(kLogTable, kLogPlace);
  static constexpr auto kExpSegments = Placed(kExpTable, kExpPlace);

  // x = (1 - u / 2) 2^-zeros; x in U1.30, 2^-30..1, u in U0.29.
  struct Octave {
    int32_t zeros, u;
  };
  static Octave OctaveOf(int32_t x) {
    const int32_t zeros = LeadingZeros(x - 1);
    const auto gap = static_cast<uint32_t>((1 << Cosine::kFraction) - x);
    return {zeros, static_cast<int32_t>((gap << zeros) & ((1U << 29) - 1))};
  }

  static const PlacedSegment& LogSegment(int32_t u) {
    return kLogSegments[static_cast<size_t>(u >> kLogPlace)];
  }
  // -log2(1 - u / 2) in U1.30.
  static int32_t Log(const PlacedSegment& segment, int32_t u) {
    const int32_t d = u - segment.start;
    const int32_t bend = MultiplyHigh(segment.curvature << 8, d >> 4 << 4);    // >> 20 of d >> 4
    return segment.value + MultiplyHigh((segment.slope + bend) << 2, d << 9);  // >> 21
  }
  static int32_t Log(int32_t u) { return Log(LogSegment(u), u); }

  // n y = octaves - g, g in U0.23. From kDark octaves on the power rounds to 0.
  struct Exponent {
    int32_t octaves, g;
  };
  static constexpr int kDark = Highlight::kFraction + 2;
  static Exponent Times(int32_t zeros, int32_t log, uint32_t n) {
    constexpr uint32_t kOne = 1 << 23, kLimit = kDark;
    const uint32_t whole = static_cast<uint32_t>(zeros) * n;
    const auto part = static_cast<uint32_t>((uint64_t{static_cast<uint32_t>(log)} * n) >> 14);
    const uint32_t t =  // U6.23
        (Least(whole, kLimit << Shininess::kFraction) << 16) + Least(part, kLimit * kOne);
    const uint32_t octaves = Least((t + kOne - 1) >> 23, kLimit);
    return {static_cast<int32_t>(octaves), static_cast<int32_t>((0 - t) & (kOne - 1))};
  }

  static const PlacedSegment& ExpSegment(int32_t g) {
    return kExpSegments[static_cast<size_t>(g >> kExpPlace)];
  }
  // 2^g in U2.22.
  static int32_t Exp2(const PlacedSegment& segment, int32_t g) {
    const int32_t d = g - segment.start;
    const int32_t slope = segment.slope + ((segment.curvature * (d >> 5)) >> 14);
    return segment.value + MultiplyHigh(slope << 2, d << 12);  // >> 18
  }
  static int32_t Exp2(int32_t g) { return Exp2(ExpSegment(g), g); }

  // 2^(g - octaves) in U1.16, rounded to nearest.
  static int32_t Round(int32_t exp2, int32_t octaves) {
    const int32_t shift = 6 + octaves;
    const int32_t rounded = (exp2 + (1 << (shift - 1))) >> shift;
    return octaves == kDark ? 0 : rounded;
  }

  // Raw highlight x^n, for x in U1.30, 2^-30..1.
  static int32_t Power(int32_t x, uint32_t n) {
    const Octave y = OctaveOf(x);
    const Exponent exponent = Times(y.zeros, Log(y.u), n);
    return Round(Exp2(exponent.g), exponent.octaves);
  }

 private:
  // Of v as a number of 30 bits; 0 has 30. A float holds the exponent of 2 v + 1: with the bit
  // below the highest cleared it cannot round up to the next power of 2.
  static int32_t LeadingZeros(int32_t v) {
    const int32_t w = 2 * v + 1;
    const auto real = static_cast<float>(w & ~(w >> 1));
    int32_t bits;
    std::memcpy(&bits, &real, sizeof bits);
    return 30 + 127 - (bits >> 23);
  }
  // floor(a b / 2^32).
  static int32_t MultiplyHigh(int32_t a, int32_t b) {
    return static_cast<int32_t>((int64_t{a} * b) >> 32);
  }
  static uint32_t Least(uint32_t a, uint32_t b) { return a < b ? a : b; }
};

}  // namespace shading
