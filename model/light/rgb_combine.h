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
      return static_cast<uint8_t>(RawCode(RawChannel(material, c),
                                          static_cast<int32_t>(diffuse.raw()),
                                          static_cast<int32_t>(highlight.raw())));
    };
    return {code(0), code(1), code(2)};
  }

  // Reflectances of one channel.
  struct Channel {
    int32_t ambient, diffuse, specular;
  };
  static Channel RawChannel(const Material& material, size_t c) {
    return {static_cast<int32_t>(material.ambient[c].raw()),
            static_cast<int32_t>(material.diffuse[c].raw()),
            static_cast<int32_t>(material.specular[c].raw())};
  }
  static int64_t RawCode(const Channel& channel, int32_t diffuse, int32_t highlight) {
    constexpr int kFraction = Reflectance::kFraction + Diffuse::kFraction;
    constexpr int64_t kOne = int64_t{1} << kFraction;
    const int64_t light = (int64_t{channel.ambient} << Diffuse::kFraction) +
                          int64_t{channel.diffuse} * diffuse +
                          ((int64_t{channel.specular} * highlight) << 1);
    const int64_t clamped = light < kOne ? light : kOne;
    return ((clamped << 8) - clamped + kOne / 2) >> kFraction;
  }
};

}  // namespace shading
