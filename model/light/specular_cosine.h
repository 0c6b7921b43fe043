// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/light_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/light/specular_cosine.sv: what lighting makes of the cosines of a pixel,
// paper 000 (1), (12).
//
//   diffuse  = N.L clamped to [0, 1]
//   specular = N.H                                    Lighting::kBlinn
//   specular = R.V = 2 (N.L)(N.V) - L.V               Lighting::kPhong
//
// Diffuse is rounded to U1.17. N.H passes unchanged; 2 (N.L)(N.V) is rounded to S3.30, R.V
// saturates at -2 and 2 - 2^-30: |error| <= 0.5 ulp of S1.30 for cosines within -1..1. The same
// arithmetic as VertexLight's.
class SpecularCosine {
 public:
  static constexpr UnitContract kContract = {"specular_cosine",
                                             "light",
                                             2,
                                             1,
                                             "cosines S1.30, light S1.22 and S1.30",
                                             "diffuse U1.17, cosine S1.30, round to nearest",
                                             0.5,
                                             "cosines within -1..1, each output in its own ulp"};

  explicit SpecularCosine(const LightState& light)
      : phong_(light.lighting == Lighting::kPhong), l_dot_v_(light.l_dot_v.raw()) {}

  Cosine Specular(const LightCosines& cosines) const {
    if (!phong_) return cosines.n_dot_h_or_v;
    return Cosine::FromRaw(Reflected(static_cast<int32_t>(cosines.n_dot_l.raw()),
                                     static_cast<int32_t>(cosines.n_dot_h_or_v.raw()), l_dot_v_));
  }

  static Diffuse DiffuseOf(const LightCosines& cosines) {
    return Diffuse::FromRaw(RawDiffuse(static_cast<int32_t>(cosines.n_dot_l.raw())));
  }

  // The same on raw numbers: R.V, and the diffuse factor.
  static int32_t Reflected(int32_t n_dot_l, int32_t n_dot_v, int64_t l_dot_v) {
    constexpr int kExtra = Cosine::kFraction - 1;        // twice the product
    const int64_t product = int64_t{n_dot_l} * n_dot_v;  // S3.60
    return SaturateCosine(((product + (int64_t{1} << (kExtra - 1))) >> kExtra) - l_dot_v);
  }
  static int32_t RawDiffuse(int32_t n_dot_l) {
    constexpr int kExtra = Cosine::kFraction - Diffuse::kFraction;
    return (ClampCosine(n_dot_l) + (1 << (kExtra - 1))) >> kExtra;
  }

  bool phong() const { return phong_; }
  int64_t l_dot_v() const { return l_dot_v_; }
  static bool Unlit(const LightCosines& cosines) { return cosines.n_dot_l.raw() <= 0; }

 private:
  bool phong_;
  int64_t l_dot_v_;
};

}  // namespace shading
