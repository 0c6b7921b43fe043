// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/slerp.h"

#include <algorithm>
#include <cmath>

namespace shading::ideal {
namespace {

using Real = long double;
using Direction = std::array<Real, 3>;

constexpr Real kLeastSum = 0x1p-24L;
constexpr Real kTie = 0x1p-20L;

Direction Combination(Real p, const Direction& a, Real q, const Direction& b) {
  return {p * a[0] + q * b[0], p * a[1] + q * b[1], p * a[2] + q * b[2]};
}

Real Length(const Direction& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

Direction Unit(const Direction& v) {
  const Real length = Length(v);
  return {v[0] / length, v[1] / length, v[2] / length};
}

Direction UnitNormal(const shading::Vector3& normal) {
  const Vector n = ToReal(normal);
  if (n == Vector{}) return {0, 0, 1};
  return Unit({n[0], n[1], n[2]});
}

Direction Perpendicular(const Direction& v) {
  const Real least = std::min({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  const auto* smallest =
      std::find_if(v.begin(), v.end(), [&](Real c) { return std::abs(c) <= least + kTie; });
  Direction axis = {};
  axis[static_cast<size_t>(smallest - v.begin())] = 1;
  const Direction unit = Unit(v);
  return Unit(Combination(1, axis, -unit[static_cast<size_t>(smallest - v.begin())], unit));
}

}  // namespace

Slerp::Direction Slerp::Interpolate(const Direction& a, const Direction& b, Real w) {
  const Direction sum = Combination(1, a, 1, b), difference = Combination(-1, a, 1, b);
  const Real psi = 2 * std::atan2(Length(difference), Length(sum));
  if (Length(sum) < kLeastSum) {
    const Real turned = (w - 0.5L) * psi;
    return Combination(std::cos(turned), Perpendicular(difference), std::sin(turned),
                       Unit(difference));
  }
  // Below this angle the weights of (2) are 1 - w and w to the last bit.
  if (psi < 0x1p-34L) return Unit(Combination(1 - w, a, w, b));
  return Combination(std::sin((1 - w) * psi) / std::sin(psi), a, std::sin(w * psi) / std::sin(psi),
                     b);
}

Slerp::Direction Slerp::OnEdge(const Vertex& upper, const Vertex& lower, Real y) {
  const Real w = (y - upper.y) / (lower.y - upper.y);
  return Interpolate(upper.normal, lower.normal, std::clamp<Real>(w, 0, 1));
}

Slerp::Real Slerp::FromEdge(const Vertex& upper, const Vertex& lower, Real x, Real y) {
  return (x - upper.x) * (lower.y - upper.y) - (lower.x - upper.x) * (y - upper.y);
}

Slerp::Slerp(const FrameState& frame, const TrianglePacket& triangle)
    : light_(frame), material_(MaterialOf(frame, triangle)) {
  for (size_t i = 0; i < vertex_.size(); ++i) {
    vertex_[i] = {triangle.x[i].ToReal(), triangle.y[i].ToReal(), UnitNormal(triangle.n[i])};
  }
  std::sort(vertex_.begin(), vertex_.end(),
            [](const Vertex& a, const Vertex& b) { return a.y < b.y; });
}

Vector Slerp::Normal(double x, double y) const {
  const auto& [top, middle, bottom] = vertex_;
  const bool above = top.y < middle.y && (y <= middle.y || middle.y == bottom.y);
  const Vertex& upper = above ? top : middle;
  const Vertex& lower = above ? middle : bottom;

  const Direction on_long = OnEdge(top, bottom, y), on_short = OnEdge(upper, lower, y);
  // Shares of the row on either side of the point, on a scale common to both.
  const Real from_long = FromEdge(top, bottom, x, y) * (lower.y - upper.y);
  const Real from_short = FromEdge(upper, lower, x, y) * (bottom.y - top.y);
  const bool long_is_left = FromEdge(top, bottom, middle.x, middle.y) > 0;
  const Real left = std::max<Real>(long_is_left ? from_long : from_short, 0);
  const Real right = std::max<Real>(long_is_left ? -from_short : -from_long, 0);
  const Real w = left + right > 0 ? left / (left + right) : 0;
  const Direction normal =
      long_is_left ? Interpolate(on_long, on_short, w) : Interpolate(on_short, on_long, w);
  return {static_cast<double>(normal[0]), static_cast<double>(normal[1]),
          static_cast<double>(normal[2])};
}

}  // namespace shading::ideal
