// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/light/light_types.h"
#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/slerp_direct.sv: the normals of one lane along a span by paper 000
// (6), with the sine and the cosine of every pixel from a CORDIC.
//
//   N = start cos(a) + side sin(a),  a = t step          lane j takes t = j, j + lanes, ...
//
// The first of kRotations rotations is the same for every angle in [0, 2): it is in the start. The
// angle is exact modulo 2; it is rounded to 36 fraction bits, sine and cosine to 28, and the sum to
// S1.24, which saturates. Angles up to 1.74 converge.
class SlerpDirect {
 public:
  static constexpr UnitContract kContract = {
      "slerp_direct",
      "normal",
      30,
      1,
      "angle U1.40, normals S1.30",
      "normal S1.24",
      0.75,
      "angles up to 1.74, unit normals at right angles; ulp of 2^-24"};

  static constexpr int kRotations = 28;

  SlerpDirect() = default;
  explicit SlerpDirect(const SpanArc& arc, int lane = 0, int lanes = 1)
      : arc_(arc),
        angle_(arc.step.raw() * lane & Angle::kMaxRaw),
        stride_(arc.step.raw() * lanes & Angle::kMaxRaw) {}

  PixelNormal normal() const {
    const Direction at = DirectionOf(angle_);
    PixelNormal normal;
    for (size_t i = 0; i < 3; ++i) {
      const int64_t sum = arc_.start[i].raw() * at.cosine + arc_.side[i].raw() * at.sine;
      normal[i] = PixelNormalComponent::FromRaw(
          std::clamp((sum + (int64_t{1} << 33)) >> 34, -kMaxNormal - 1, kMaxNormal));
    }
    return normal;
  }
  void Step() { angle_ = (angle_ + stride_) & Angle::kMaxRaw; }

 private:
  struct Direction {
    int64_t cosine, sine;  // S1.28
  };
  static constexpr int64_t kMaxNormal = (int64_t{1} << (PixelNormalComponent::kWidth - 1)) - 1;
  // 1/K with 34 fraction bits, K = product of sqrt(1 + 4^-k): x and y after the first rotation.
  static constexpr int64_t kStart = 0x26dd3b6a1;
  static constexpr int64_t kEighthTurn = 0xc90fdaa22;  // atan(1), 36 fraction bits
  // atan(2^-k), k = 1..27, 36 fraction bits.
  static constexpr std::array<int64_t, kRotations - 1> kTurn = {
      0x76b19c158, 0x3eb6ebf26, 0x1fd5ba9ab, 0xffaaddb9, 0x7ff556ef, 0x3ffeaab7, 0x1fffd556,
      0xffffaab,   0x7ffff55,   0x3ffffeb,   0x1fffffd,  0x1000000,  0x800000,   0x400000,
      0x200000,    0x100000,    0x80000,     0x40000,    0x20000,    0x10000,    0x8000,
      0x4000,      0x2000,      0x1000,      0x800,      0x400,      0x200};

  static Direction DirectionOf(int64_t angle) {
    int64_t x = kStart, y = kStart, z = ((angle + 8) >> 4) - kEighthTurn;
    for (int k = 1; k < kRotations; ++k) {
      const int64_t back = z >> 63;  // all ones: turn back
      const int64_t dx = ((y >> k) ^ back) - back, dy = ((x >> k) ^ back) - back;
      z -= (kTurn[static_cast<size_t>(k - 1)] ^ back) - back;
      x -= dx;
      y += dy;
    }
    return {(x + 32) >> 6, (y + 32) >> 6};
  }

  SpanArc arc_;
  int64_t angle_ = 0, stride_ = 0;
};

}  // namespace shading
