// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/footprint/footprint_shader.h"
#include "model/light/quad_cosine_shader.h"
#include "model/normal/adaptive_shader.h"
#include "model/normal/linear_shader.h"
#include "model/normal/phong_direct.h"
#include "model/normal/phong_surface_shader.h"
#include "model/normal/slerp_shader.h"
#include "model/normal/taylor_normalizer.h"

namespace shading {

// Bit-exact model of rtl/normal/normal_shader.sv: a class per method, and what the pipeline must
// know of it.

// Cycles from the walker to the cosines.
constexpr int CosineLatency(Method method) {
  switch (method) {
    case Method::kPhong: return LinearShader<PhongDirect, 1>::kLatency;
    case Method::kPhongTaylor: return LinearShader<TaylorNormalizer, 1>::kLatency;
    case Method::kPhongSurface: return PhongSurfaceShader<1>::kLatency;
    case Method::kPhongDuff: return DuffShader<1>::kLatency;
    case Method::kSlerp: return SlerpShader<1>::kLatency;
    case Method::kSlerpPaper: return SlerpPaperShader<1>::kLatency;
    case Method::kSlerpDirect: return SlerpDirectShader<1>::kLatency;
    case Method::kAdaptive:
    case Method::kAdaptivePaper:
    case Method::kAdaptiveChord: return AdaptiveShader<1>::kLatency;
    case Method::kFootprint:
    case Method::kFootprintPaper: return FootprintShader<1>::kLatency;
    default: return 0;
  }
}

constexpr AdaptiveKind AdaptiveKindOf(Method method) {
  return method == Method::kAdaptivePaper   ? AdaptiveKind::kExtended
         : method == Method::kAdaptiveChord ? AdaptiveKind::kChord
                                            : AdaptiveKind::kSphere;
}

constexpr SetupKind SetupKindOf(Method method) {
  SetupKind kind;
  kind.spherical = IsSpherical(method);
  kind.cosines = method == Method::kPhongDuff || method == Method::kSlerpIntensity;
  kind.length = method == Method::kPhongDuff;
  return kind;
}

}  // namespace shading
