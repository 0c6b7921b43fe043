// SPDX-License-Identifier: Apache-2.0
#include "model/normal/edge_normals.h"

#include <algorithm>

namespace shading {
namespace {

constexpr int64_t kPixel = int64_t{1} << ScreenCoord::kFraction;

int64_t CentreOf(int64_t row) { return row * kPixel + kPixel / 2; }

// First row whose centre is not above y.
int FirstRow(int64_t y) {
  return static_cast<int>(FloorDivide(y - kPixel / 2 + kPixel - 1, kPixel));
}

}  // namespace

EdgeNormals::EdgeNormals(int64_t top, int64_t bottom, const ArcVector& top_normal,
                         const ArcVector& bottom_normal, int first_row)
    : row_(std::max(FirstRow(top), first_row)) {
  const int64_t first = CentreOf(row_) - top, height = bottom - top;
  if (first > height) return;  // between two rows, or off the screen
  const auto at = [&](int64_t y) {
    return ArcRatio(static_cast<Uint128>(y), static_cast<Uint128>(height));
  };
  const SphereArc arc(top_normal, bottom_normal);
  normal_ = arc.At(at(first));
  if (first + kPixel > height) return;  // never stepped
  const ArcVector next = arc.At(at(first + kPixel));
  for (size_t c = 0; c < 3; ++c) difference_[c] = next[c] - normal_[c];
  const int64_t sine = SineCosineOf(ArcProduct(arc.half_angle(), at(kPixel))).sine;
  kappa_ = RoundShift(static_cast<Int128>(sine) * sine, kArcFraction - 2);
  // difference_ is D before the step from normal_: D(t-1) = D(t) + kappa N(t).
  for (size_t c = 0; c < 3; ++c) difference_[c] += ArcProduct(kappa_, normal_[c]);
}

const ArcVector& EdgeNormals::At(int row) {
  for (; row_ < row; ++row_) {
    for (size_t c = 0; c < 3; ++c) {
      difference_[c] -= ArcProduct(kappa_, normal_[c]);
      normal_[c] += difference_[c];
    }
  }
  return normal_;
}

RowEnds::RowEnds(const TriangleGeometry& geometry, const TrianglePacket& packet)
    : box_x_(geometry.box_x), box_y_(geometry.box_y) {
  std::array<ArcVector, 3> normal;  // of the corners, as the y below
  std::array<int64_t, 3> y;
  for (size_t i = 0; i < 3; ++i) {
    const auto v = static_cast<size_t>(geometry.corner[i]);
    normal[i] = UnitOf(packet.n[v]);
    y[i] = packet.y[v].raw();
  }
  std::array<size_t, 3> order = {0, 1, 2};
  std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return y[a] < y[b]; });
  const auto [top, middle, bottom] = order;
  has_upper_ = y[top] < y[middle];
  long_ = MakeSide(geometry, packet, top, bottom, normal);
  if (has_upper_) upper_ = MakeSide(geometry, packet, top, middle, normal);
  if (y[middle] < y[bottom]) lower_ = MakeSide(geometry, packet, middle, bottom, normal);
  long_is_left_ = long_.edge.dx > 0;
}

RowEnds::Side RowEnds::MakeSide(const TriangleGeometry& geometry, const TrianglePacket& packet,
                                size_t a, size_t b, const std::array<ArcVector, 3>& normal) const {
  const auto y = [&](size_t i) { return packet.y[static_cast<size_t>(geometry.corner[i])].raw(); };
  return {geometry.edge[3 - a - b], EdgeNormals(y(a), y(b), normal[a], normal[b], box_y_), y(b)};
}

SphereArc RowEnds::Row(int row) {
  Side& other = has_upper_ && CentreOf(row) <= upper_.bottom ? upper_ : lower_;
  Side& left = long_is_left_ ? long_ : other;
  Side& right = long_is_left_ ? other : long_;
  left_ = &left.edge;
  right_ = &right.edge;
  left_at_ = left_->w0 + (row - box_y_) * left_->dy;
  right_at_ = right_->w0 + (row - box_y_) * right_->dy;
  return {left.normals.At(row), right.normals.At(row)};
}

// x - x_l = w_l / dx_l and x_r - x = w_r / -dx_r, exact in edge functions: no sliver is too thin.
int64_t RowEnds::Weight(int x) const {
  const auto from = [&](const Edge& edge, int64_t at, int64_t dx) {
    const int64_t w = at + (x - box_x_) * edge.dx;
    return w > 0 ? static_cast<Uint128>(w) * static_cast<Uint128>(dx / kPixel) : Uint128{0};
  };
  const Uint128 left = from(*left_, left_at_, -right_->dx);
  const Uint128 right = from(*right_, right_at_, left_->dx);
  return left + right == 0 ? 0 : ArcRatio(left, left + right);
}

}  // namespace shading
