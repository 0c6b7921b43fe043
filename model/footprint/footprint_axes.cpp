// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/footprint_axes.h"

#include <algorithm>

namespace shading {
namespace {

Int128 Magnitude(Int128 value) { return value < 0 ? -value : value; }

// Bits that `values` need beyond `bits`, of the largest magnitude.
template <size_t kCount>
int Excess(const std::array<Int128, kCount>& values, int bits) {
  Int128 most = 0;
  for (const Int128 value : values) most = std::max(most, Magnitude(value));
  int excess = 0;
  while (most >> excess >= Int128{1} << bits) ++excess;
  return excess;
}

Int128 Dot(const std::array<int64_t, 3>& a, const std::array<int64_t, 3>& b) {
  Int128 sum = 0;
  for (size_t c = 0; c < 3; ++c) sum += static_cast<Int128>(a[c]) * b[c];
  return sum;
}

}  // namespace

std::array<Edge, 3> EdgesByVertex(const TriangleGeometry& geometry) {
  std::array<Edge, 3> edge;
  for (size_t i = 0; i < 3; ++i) edge[static_cast<size_t>(geometry.corner[i])] = geometry.edge[i];
  return edge;
}

FootprintAxes FootprintAxes::Of(const Slope& slope, const std::array<int64_t, 3>& normal) {
  // Slopes of 30 bits, so that products with two normals of 24 bits fit.
  const int shift =
      Excess<6>({slope.dx[0], slope.dx[1], slope.dx[2], slope.dy[0], slope.dy[1], slope.dy[2]}, 30);
  Slope s;
  for (size_t c = 0; c < 3; ++c) {
    s.dx[c] = slope.dx[c] >> shift;
    s.dy[c] = slope.dy[c] >> shift;
  }
  const Int128 length = Dot(normal, normal), x = Dot(s.dx, normal), y = Dot(s.dy, normal);
  std::array<Int128, 3> e = {Dot(s.dx, s.dx) * length - x * x, Dot(s.dx, s.dy) * length - x * y,
                             Dot(s.dy, s.dy) * length - y * y};
  const int excess = Excess(e, 60);
  for (Int128& value : e) value >>= excess;
  const Int128 difference = e[0] - e[2];
  const Int128 root = IntegerRoot(static_cast<Uint128>(difference * difference + 4 * e[1] * e[1]));
  FootprintAxes axes;
  if (root == 0) return axes;
  // cos and sin of half the angle whose cosine is difference / root.
  const auto half = [root](Int128 sum) {
    const Int128 square = (std::max<Int128>(sum, 0) << 60) / (2 * root);
    return static_cast<int64_t>(IntegerRoot(static_cast<Uint128>(square)));
  };
  axes.x = half(root + difference);
  axes.y = e[1] < 0 ? -half(root - difference) : half(root - difference);
  return axes;
}

FootprintReach::FootprintReach(const std::array<Edge, 3>& edge, int64_t area,
                               int64_t limit_halves) {
  Int128 longest = 0;  // square of the longest edge: the steepest barycentric
  for (const Edge& e : edge) {
    longest =
        std::max(longest, static_cast<Int128>(e.dx) * e.dx + static_cast<Int128>(e.dy) * e.dy);
  }
  constexpr int kExtra = 20;  // fraction bits of the root
  const Int128 steepest = IntegerRoot(static_cast<Uint128>(longest) << (2 * kExtra));
  const Int128 allowed = limit_halves * static_cast<Int128>(area);
  const bool limited = 2 * kRadius * steepest > allowed << (kFraction + kExtra);
  numerator_ = limited ? limit_halves << kExtra : kRadius;
  divisor_ = limited ? 2 * steepest : static_cast<Int128>(area) << kFraction;
}

std::array<int64_t, 3> FootprintReach::Along(const Slope& slope, int64_t x, int64_t y,
                                             int slope_fraction, int fraction) const {
  std::array<int64_t, 3> change;
  const int shift = slope_fraction + kFraction - fraction;  // of the sum below
  for (size_t c = 0; c < 3; ++c) {
    const Int128 sum = static_cast<Int128>(slope.dx[c]) * x + static_cast<Int128>(slope.dy[c]) * y;
    const Int128 divisor = divisor_ << shift;
    change[c] =
        static_cast<int64_t>(FloorDivide<Int128>(2 * sum * numerator_ + divisor, 2 * divisor));
  }
  return change;
}

}  // namespace shading
