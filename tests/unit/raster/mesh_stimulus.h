// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "tests/unit/raster/packet_stimulus.h"

namespace shading {

// A random triangulation of a rectangle, without T-junctions: points are inserted one by one, then
// diagonals of convex quadrilaterals are flipped, which makes slivers.
class Mesh {
 public:
  using Triangle = std::array<size_t, 3>;  // clockwise

  Mesh(Point low, Point high)
      : point_{low, {high.x, low.y}, high, {low.x, high.y}}, triangle_{{0, 1, 2}, {0, 2, 3}} {}

  void Insert(Point p) {
    for (size_t t = 0; t < triangle_.size(); ++t) {
      const Triangle v = triangle_[t];
      size_t zeros = 0, on = 0;
      bool inside = true;
      for (size_t k = 0; k < 3; ++k) {
        const Int128 w = Cross(p, point_[v[(k + 1) % 3]], point_[v[(k + 2) % 3]]);
        inside = inside && w >= 0;
        if (w == 0) ++zeros, on = k;
      }
      if (!inside) continue;
      if (zeros > 1) return;  // a vertex already
      point_.push_back(p);
      const size_t apex = point_.size() - 1;
      if (zeros == 1) return SplitEdge(t, on, apex);
      triangle_[t] = {v[0], v[1], apex};
      triangle_.push_back({v[1], v[2], apex});
      triangle_.push_back({v[2], v[0], apex});
      return;
    }
  }

  void Flip(size_t t, size_t k) {
    const size_t c = triangle_[t][k], a = triangle_[t][(k + 1) % 3], b = triangle_[t][(k + 2) % 3];
    const auto [u, m] = Across(a, b);
    if (u == kNone) return;
    const size_t d = triangle_[u][m];
    if (Cross(point_[c], point_[a], point_[d]) <= 0) return;
    if (Cross(point_[c], point_[d], point_[b]) <= 0) return;
    triangle_[t] = {c, a, d};
    triangle_[u] = {c, d, b};
  }

  size_t size() const { return triangle_.size(); }
  Point vertex(size_t t, size_t k) const { return point_[triangle_[t][k]]; }
  Corners At(size_t t) const { return {vertex(t, 0), vertex(t, 1), vertex(t, 2)}; }

 private:
  static constexpr size_t kNone = ~size_t{0};

  // The triangle on the other side of edge ab, and its corner that is not on it.
  std::pair<size_t, size_t> Across(size_t a, size_t b) const {
    for (size_t u = 0; u < triangle_.size(); ++u) {
      for (size_t m = 0; m < 3; ++m) {
        if (triangle_[u][(m + 1) % 3] == b && triangle_[u][(m + 2) % 3] == a) return {u, m};
      }
    }
    return {kNone, 0};
  }
  void SplitEdge(size_t t, size_t k, size_t p) {
    const size_t c = triangle_[t][k], a = triangle_[t][(k + 1) % 3], b = triangle_[t][(k + 2) % 3];
    const auto [u, m] = Across(a, b);
    triangle_[t] = {c, a, p};
    triangle_.push_back({c, p, b});
    if (u == kNone) return;
    const size_t d = triangle_[u][m];
    triangle_[u] = {d, b, p};
    triangle_.push_back({d, p, a});
  }

  std::vector<Point> point_;
  std::vector<Triangle> triangle_;
};

inline Mesh RandomMesh(CornerGenerator* random, Point low, Point high, int points) {
  Mesh mesh(low, high);
  for (int i = 0; i < points; ++i) {
    const size_t t = static_cast<size_t>(random->Integer(0, static_cast<int64_t>(mesh.size()) - 1));
    const Point a = mesh.vertex(t, 0), b = mesh.vertex(t, 1);
    Point p = {random->Integer(low.x, high.x), random->Integer(low.y, high.y)};
    switch (random->Integer(0, 6)) {
      case 0: break;  // anywhere
      case 1: p.x = FloorDivide(p.x, kPixel) * kPixel + kPixel / 2; [[fallthrough]];
      case 2: p.y = FloorDivide(p.y, kPixel) * kPixel + kPixel / 2; break;  // through centres
      case 3: p.x = a.x; break;                                             // above another
      case 4: p.y = a.y; break;
      case 5: p = random->Near(a, 3); break;
      case 6: p = random->Near({(a.x + b.x) / 2, (a.y + b.y) / 2}, 2); break;  // sliver
    }
    mesh.Insert(p);
  }
  for (int i = 0; i < points; ++i) {
    mesh.Flip(static_cast<size_t>(random->Integer(0, static_cast<int64_t>(mesh.size()) - 1)),
              static_cast<size_t>(random->Integer(0, 2)));
  }
  return mesh;
}

}  // namespace shading
