// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "model/light/cosine.h"
#include "model/unit_contract.h"

namespace shading {

// Cosines of the normalised mean of two or three normals: the middle of an edge by bisection,
// paper 002 (1), or the face normal of flat shading. The normal itself is never formed:
//
//   N = (Na + Nb) / z,  z = |Na + Nb|   =>   N.L = (Na.L + Nb.L) / z
//
// Input: S1.22 normals, unit within 2^-10, and their S1.30 cosines; output S1.30. z has 30
// fraction bits; root and quotient are rounded to nearest, halves away from zero.
// |error| <= 2 / z + 0.5 ulp of S1.30 against real arithmetic on the same normals, 2.5 where z >= 1
// (two unit normals up to 120 degrees apart); it includes half an ulp for each cosine.
// Undefined (nullopt) where z^2 < 2^-10: two normals opposed within 1.8 degrees. Cosines that do
// not belong to the normals saturate.
class MeanCosines {
 public:
  static constexpr UnitContract kContract = {"mean_cosines",
                                             "light",
                                             0,
                                             0,
                                             "2 or 3 normals S1.22, cosines S1.30",
                                             "S1.30, round to nearest",
                                             2.5,
                                             "unit vectors, length of their sum >= 1"};

  template <size_t N>
  static std::optional<LightCosines> Of(const std::array<Vector3, N>& normals,
                                         const std::array<LightCosines, N>& cosines) {
    static_assert(N == 2 || N == 3, "an edge or a face");
    Sum sum;
    for (size_t i = 0; i < N; ++i) {
      for (size_t c = 0; c < sum.normal.size(); ++c) sum.normal[c] += normals[i][c].raw();
      sum.n_dot_l += cosines[i].n_dot_l.raw();
      sum.n_dot_h_or_v += cosines[i].n_dot_h_or_v.raw();
    }
    return Normalise(sum);
  }

  // Flat shading: the mean of three, or the first vertex where that is undefined.
  static LightCosines OfFace(const std::array<Vector3, 3>& normals,
                              const std::array<LightCosines, 3>& cosines) {
    return Of(normals, cosines).value_or(cosines[0]);
  }

 private:
  struct Sum {
    std::array<int64_t, 3> normal = {};     // S3.22
    int64_t n_dot_l = 0, n_dot_h_or_v = 0;  // S3.30
  };
  static std::optional<LightCosines> Normalise(const Sum& sum);
};

}  // namespace shading
