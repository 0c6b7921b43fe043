// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/blinn_specular.h"
#include "model/light/pixel_light_block.h"
#include "model/light/rgb_combine.h"
#include "model/light/specular_cosine.h"

namespace shading {

// Bit-exact model of rtl/light/pixel_light.sv: the light of a pixel from its cosines, for the
// material that was set last. Paper 000 (1), (12), the highlight not gated by N.L:
//
//   I = ka + kd (N.L) + ks (N.H)^n                    Lighting::kBlinn
//   I = ka + kd (N.L) + ks (R.V)^n                    Lighting::kPhong
//
// |error| before the code is rounded, for kd, ks <= 1: 255 (2^-18 kd + 0.65 2^-16 ks) < 0.0036
// codes for the cosines as they are. Real cosines, rounded to S1.30: under 0.0037 for Blinn and
// 0.0038 for Phong, at n = 256.
class PixelLight {
 public:
  static constexpr UnitContract kContract = {"pixel_light",
                                             "light",
                                             13,
                                             1,
                                             "cosines S1.30, material U1.16, shininess U9.7",
                                             "code U8.0, round to nearest, clamp",
                                             0.504,
                                             "unit vectors, reflectances 0..1, shininess 1..256"};

  // A pixel and what the counters want to know of it.
  struct Report {
    PixelCodes codes;
    bool unlit;         // N.L <= 0
    bool no_highlight;  // the power was not computed
  };

  explicit PixelLight(const LightState& light);

  void SetMaterial(const Material& material, bool highlight = true);  // false: it is not wanted

  PixelCodes Shade(const LightCosines& cosines) const { return ShadeAndReport(cosines).codes; }

  Report ShadeAndReport(const LightCosines& cosines) const {
    Highlight highlight;
    bool no_highlight = true;
    if (constants_.has_specular) {
      const Cosine specular = cosine_.Specular(cosines);
      no_highlight = !BlinnSpecular::Lit(specular);
      highlight = power_.Of(specular);
    }
    return {RgbCombine::Of(SpecularCosine::DiffuseOf(cosines), highlight, material_),
            SpecularCosine::Unlit(cosines), no_highlight};
  }

  // The same for the first `count` pixels of a block.
  PixelLightBlock::Counts ShadeBlock(size_t count, PixelLightBlock* block) const {
    return block->Shade(constants_, count);
  }

 private:
  SpecularCosine cosine_;
  BlinnSpecular power_;
  Material material_;
  LightConstants constants_;
};

}  // namespace shading
