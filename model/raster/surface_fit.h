// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/light/cosine.h"
#include "model/normal/normal_types.h"
#include "model/raster/triangle_setup.h"
#include "model/shading_types.h"
#include "model/triangle_packet.h"
#include "model/unit_contract.h"

namespace shading {

// Values at the nodes of a triangle: corner i, and the middle of the edge opposite corner i.
template <typename Value>
struct Nodes {
  std::array<Value, 3> corner;
  std::array<Value, 3> middle;
};
using SurfaceNodes = Nodes<Intensity>;

// The second-order surface through the six nodes of a triangle, paper 003 (2), in closed form. With
// barycentrics l_i = a_i x + b_i y + c_i and e_ij = I_ij - (I_i + I_j) / 2:
//
//   I = sum l_i I_i + 4 sum l_i l_j e_ij
//   A = 4 sum a_i a_j e_ij,  B = 4 sum b_i b_j e_ij,  C = 4 sum (a_i b_j + a_j b_i) e_ij, ...
//
// Coefficients are rounded to nearest and kept modulo 2^36 (S9.26), cosines' modulo 2^46 (S1.44): a
// sliver's may be far out of range, its pixels never are (-85..340 for nodes 0..255). F of an
// intensity carries the half code for rounding; that of a term or a cosine does not.
//
// Error     0.38 codes on screens of 4096 x 4096 pixels, 0.10 on 2048 x 2048: coefficients
//           (x^2 + xy + y^2 + x + y + 1) 2^-27, barycentrics 2295 (x + y + 1) 2^-34. Cosines:
//           2^-16.6 and 2^-17.7, coefficients (..) 2^-45 and barycentrics 18 (x + y + 1) 2^-34.
class SurfaceFit {
 public:
  static constexpr UnitContract kContract = {
      "surface_fit",
      "raster",
      0,
      0,
      "nodes U8.16, cosines S1.30, barycentric planes S1.33",
      "coefficients S9.26, S1.44, modulo 2^36, 2^46",
      0.4,
      "in codes, before rounding, on screens of 4096 x 4096 pixels"};

  static Surface Constant(Intensity value);
  static Surface Linear(const std::array<Plane, 3>& barycentric,
                        const std::array<Intensity, 3>& corner);
  static Surface Quadratic(const std::array<Plane, 3>& barycentric, const SurfaceNodes& nodes);
  static Surface Term(const std::array<Plane, 3>& barycentric, const Nodes<SignedIntensity>& nodes);
  // What the mean over a pixel's footprint, paper 001, adds to a quadratic at every pixel: the
  // second moments of the disc of radius r = 1/sqrt(3) pixels, r^2 (A + B) / 4 = (A + B) / 12, a
  // constant of the triangle. Where the disc spans more than half a barycentric, the disc that
  // spans as much; so it is at most 3/4 of the largest |e_ij|. Rounded to nearest.
  static IntensityAcc FootprintMean(const TriangleGeometry& geometry, const SurfaceNodes& nodes);
  static CosineSurface OfCosine(const std::array<Plane, 3>& barycentric,
                                const Nodes<Cosine>& nodes);
  // N.L of the linear normal N, and its |N|^2: exact, but for coefficients within 2^-45 and the
  // barycentrics, which move N by 2 l (x + y + 1) 2^-34, l the longest |Ni - Nj|.
  static CosineSurface PlaneOfCosine(const std::array<Plane, 3>& barycentric,
                                     const std::array<Cosine, 3>& corner);
  static CosineSurface OfSquare(const std::array<Plane, 3>& barycentric,
                                const Nodes<LengthSquare>& nodes);
};

}  // namespace shading
