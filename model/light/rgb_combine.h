// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/light_types.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/light/rgb_combine.sv: the colour of a pixel, paper 000 (1), (12).
//
//   I = ka + kd (N.L) + ks (N.H)^n,  code = round(255 I)
//
// Diffuse factor U1.17, highlight U1.16, reflectances U1.16; I is exact in 33 fraction bits,
// clamped to 1 and rounded once, halves up: |error| <= 0.5 codes. Reflectances over 1 are accepted.
class RgbCombine {
 public:
  static constexpr UnitContract kContract = {"rgb_combine",
                                             "light",
                                             3,
                                             1,
                                             "diffuse U1.17, highlight U1.16, material U1.16",
                                             "code U8.0, round to nearest, clamp",
                                             0.5,
                                             "all inputs"};

  static PixelCodes Of(Diffuse diffuse, Highlight highlight, const Material& material) {
    const auto code = [&](size_t c) {
      return CodeOf(material.ambient[c], material.diffuse[c], material.specular[c], diffuse.raw(),
                    highlight.raw());
    };
    return {code(0), code(1), code(2)};
  }

 private:
  static uint8_t CodeOf(Reflectance ambient, Reflectance diffuse, Reflectance specular,
                        int64_t n_dot_l, int64_t highlight) {
    constexpr int kFraction = Reflectance::kFraction + Diffuse::kFraction;
    constexpr int64_t kOne = int64_t{1} << kFraction;
    const int64_t light = (ambient.raw() << Diffuse::kFraction) + diffuse.raw() * n_dot_l +
                          ((specular.raw() * highlight) << 1);
    const int64_t clamped = light < kOne ? light : kOne;
    return static_cast<uint8_t>(((clamped << 8) - clamped + kOne / 2) >> kFraction);
  }
};

}  // namespace shading
