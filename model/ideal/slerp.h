// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/ideal/lighting.h"

namespace shading::ideal {

// Paper 000: spherical-angular interpolation of normals. The row through a point cuts the left and
// the right edge of the triangle; the normals there are slerp of the vertices' unit normals, from
// the upper to the lower vertex; the normal of the point is slerp between them, from left to right:
//
//   N(w) = [sin((1 - w) psi) Na + sin(w psi) Nb] / sin psi            paper 000 (2)
//
// The picture depends on how the triangle is turned. Outside the triangle w is clamped to [0, 1]; a
// row that is a point has w = 0. A zero normal counts as (0, 0, 1).
//
// Opposed normals, |Na + Nb| < 2^-24: the arc from Na to Nb turns through the perpendicular of
// Nb - Na that is nearest to the axis of its smallest component; components within 2^-20 of the
// smallest count as equal, the first one wins.
class Slerp {
 public:
  Slerp(const FrameState& frame, const TrianglePacket& triangle);

  Rgb At(double x, double y) const { return light_.Shade(Normal(x, y), material_); }
  Vector Normal(double x, double y) const;  // unit

 private:
  using Real = long double;
  using Direction = std::array<Real, 3>;
  struct Vertex {
    Real x, y;
    Direction normal;
  };

  static Direction Interpolate(const Direction& a, const Direction& b, Real w);
  static Direction OnEdge(const Vertex& upper, const Vertex& lower, Real y);
  // Distance of a point from an edge along the row, times the edge's height; positive to the right.
  static Real FromEdge(const Vertex& upper, const Vertex& lower, Real x, Real y);

  Light light_;
  Material material_;
  std::array<Vertex, 3> vertex_;  // top to bottom
};

}  // namespace shading::ideal
