// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/raster/triangle_setup.h"
#include "model/shading_types.h"
#include "model/triangle_packet.h"
#include "model/unit_contract.h"

namespace shading {

// Intensities of one channel at the nodes of a triangle: corner i, and the middle of the edge
// opposite corner i.
struct SurfaceNodes {
  std::array<Intensity, 3> corner;
  std::array<Intensity, 3> middle;
};

// The second-order surface through the six nodes of a triangle, paper 003 (2), in closed form. With
// barycentrics l_i = a_i x + b_i y + c_i and e_ij = I_ij - (I_i + I_j) / 2:
//
//   I = sum l_i I_i + 4 sum l_i l_j e_ij
//   A = 4 sum a_i a_j e_ij,  B = 4 sum b_i b_j e_ij,  C = 4 sum (a_i b_j + a_j b_i) e_ij, ...
//
// Coefficients are rounded to nearest S9.26 and kept modulo 2^36: a sliver's may be far out of
// range, its pixels never are (-85..340 for nodes 0..255). F carries the half code for rounding.
//
// Error     0.40 codes on screens of 4096 x 4096 pixels, 0.11 on 2048 x 2048: coefficients
//           (x^2 + xy + y^2 + x + y + 1) 2^-27, barycentrics 2295 (x + y + 1) 2^-31.
class SurfaceFit {
 public:
  static constexpr UnitContract kContract = {
      "surface_fit", "raster", 0, 0, "nodes U8.16, barycentric planes S1.30",
      "coefficients S9.26, modulo 2^36", 0.4,
      "in codes, before rounding, on screens of 4096 x 4096 pixels"};

  static Surface Constant(Intensity value);
  static Surface Linear(const std::array<Plane, 3>& barycentric,
                        const std::array<Intensity, 3>& corner);
  static Surface Quadratic(const std::array<Plane, 3>& barycentric, const SurfaceNodes& nodes);
};

}  // namespace shading
