// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/fixed/fixed.h"
#include "model/light/cosine.h"
#include "model/triangle_packet.h"

namespace shading {

// Twins of the typedefs in rtl/pkg/light_pkg.sv.
using PixelNormalComponent = S<1, 24>;
using PixelNormal = std::array<PixelNormalComponent, 3>;
using Diffuse = U<1, 17>;    // N.L clamped to 0..1
using Highlight = U<1, 16>;  // (N.H)^n, 0..1

inline constexpr uint32_t kMaxMaterials = 256;  // of one frame

// Light and viewer are at infinity: constants of a frame.
struct LightState {
  Lighting lighting = Lighting::kBlinn;
  Vector3 light;
  Vector3 half_or_view;  // H for kBlinn, V for kPhong
  Cosine l_dot_v;        // used by kPhong
};

inline LightState LightOf(const FrameState& frame) {
  return {frame.lighting, frame.light, frame.lighting == Lighting::kBlinn ? frame.half : frame.view,
          CosineOf(frame.light, frame.view)};
}

// Codes of a pixel as they leave the light units.
struct PixelCodes {
  uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const PixelCodes& a, const PixelCodes& b) {
    return a.r == b.r && a.g == b.g && a.b == b.b;
  }
};

}  // namespace shading
