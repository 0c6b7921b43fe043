// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/ideal/barycentric.h"
#include "model/ideal/gouraud.h"
#include "model/ideal/lighting.h"

namespace shading::ideal {

// Paper 003 (2) in barycentric form: the quadratic through the light of the three vertices and of
// the three middles of the edges, whose normals are bisections, paper 002 (1):
//
//   I = sum lam_i I_i + 4 sum over i < j of lam_i lam_j e_ij,  e_ij = I_ij - (I_i + I_j) / 2
//
// e_ij = 0, a straight edge, where the normals are opposed (|Ni + Nj| < 2^-5). The six node values
// are clamped to 0..255, which bounds the surface to -85..340 inside the triangle.
class Quadratic {
 public:
  Quadratic(const FrameState& frame, const TrianglePacket& triangle);

  Rgb AtUnclamped(double x, double y) const;
  Rgb At(double x, double y) const { return Clamped(AtUnclamped(x, y)); }

 private:
  Barycentric barycentric_;
  Gouraud linear_;
  std::array<Rgb, 3> excess_;  // e_12, e_20, e_01: of the edge opposite each vertex
};

}  // namespace shading::ideal
