// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/light/light_types.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// The light of one normal, paper 000 (1), (12), with the cosines clamped to [0, 1]; the highlight
// is not gated by N.L:
//
//   I = ka + kd (N.L) + ks (N.H)^n                        Lighting::kBlinn
//   I = ka + kd (N.L) + ks (R.V)^n,  R.V = 2 (N.L)(N.V) - L.V      kPhong
//
// Input: S1.22 vectors, U1.16 material, U9.7 shininess. N.L, N.H, N.V, L.V and R.V are rounded to
// S1.30; I, exact in 46 fraction bits, is clamped to 1 and rounded once, to U8.16 codes.
// |error| in ulp of U8.16, s the largest specular coefficient: 0.52 + 2.01 s for Blinn, 0.52 +
// 11.98 s for Phong at n = 256, in proportion to n below: (N.H)^n magnifies the 30th bit.
// Vectors that are not unit give the formula's value of them as they are; cosines saturate.
class VertexLight {
 public:
  static constexpr UnitContract kContract = {"vertex_light",
                                             "light",
                                             0,
                                             0,
                                             "normal S1.22, material U1.16, shininess U9.7",
                                             "U8.16, round to nearest",
                                             12.5,
                                             "unit vectors, reflectances 0..1, shininess 1..256"};

  explicit VertexLight(const FrameState& frame) : light_(LightOf(frame)) {}

  // The terms of the light apart, diffuse with N.L not clamped: for surfaces that are clamped per
  // pixel. Each within 0.5 ulp of its own, beside the highlight's error above.
  struct Terms {
    std::array<SignedIntensity, kChannels> diffuse, specular;
  };

  LightCosines Cosines(const Vector3& normal) const;
  // ka of one channel.
  static Intensity Ambient(const Material& material, size_t channel);
  Terms ShadeTerms(const LightCosines& cosines, const Material& material) const;
  std::array<Intensity, kChannels> Shade(const LightCosines& cosines,
                                         const Material& material) const;

 private:
  int64_t HighlightRaw(const LightCosines& cosines, const Material& material) const;

  LightState light_;
};

}  // namespace shading
