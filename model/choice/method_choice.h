// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/choice/choice_types.h"
#include "model/light/light_types.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/choice/method_choice.sv: the cheapest method of a triangle whose error
// against exact Blinn-Phong of the linear normal is at most the tolerance T on every pixel, and at
// most T / 2 on its edges, so that neighbours differ there by at most T:
//
//   2^Ld + 2^Ls <= 1,  Ld >= log2(Ed / T),  Ls >= log2(Es / T)
//
// of the diffuse and the specular light; bounds of every method in docs/units/choice. First of
// flat, gouraud, quad, quad-cosine; else one that is exact, phong-surface up to a turn of 104
// degrees, phong-duff beyond.
//
// Logarithms S6.5, rounded up. Without a clock. The arithmetic of the chosen method comes on top.
// Any input is good; normals count as unit.
class MethodChoice {
 public:
  static constexpr UnitContract kContract = {
      "method_choice",
      "choice",
      0,
      1,
      "turn U2.22, cosines S1.16, logarithms S6.5",
      "method and skips",
      1,
      "codes of the tolerance, before rounding; unit normals"};

  // phong-surface: up to 104 degrees |N|^2 is at least 1/6 on the triangle.
  static constexpr int64_t kSurfaceTurn = int64_t{5} << (Turn::kFraction - 1);

  // From the normals of the vertices and what they contribute to lighting.
  static LightRange RangeOf(const std::array<Vector3, 3>& normals,
                            const std::array<LightCosines, 3>& cosines, const LightState& light);
  // Of a material, once a frame.
  static ChoiceLimit LimitOf(const Material& material, Tolerance tolerance);
  // The one that shades Phong's normal itself: phong-surface or phong-duff.
  static Method ExactOf(const LightRange& range) {
    return range.turn.raw() <= kSurfaceTurn ? Method::kPhongSurface : Method::kPhongDuff;
  }
  static Choice Of(const LightRange& range, const ChoiceLimit& limit, Lighting lighting);

  // What Of compares: whether a method can be chosen at all, and the two logarithms in 2^-5.
  struct Bound {
    Method method;
    bool allowed;
    int diffuse, specular;
  };
  static constexpr size_t kBounds = 4;
  static std::array<Bound, kBounds> BoundsOf(const LightRange& range, const ChoiceLimit& limit,
                                             Lighting lighting);
  // log2(2^a + 2^b) in 2^-5, at most 1 / 250 of the sum too low.
  static int LogAdd(int a, int b);
};

}  // namespace shading
