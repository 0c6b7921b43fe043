// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace shading {

// How a triangle is shaded. The value is the bit of the method in the RTL parameter Methods.
enum class Method {
  kFlat,
  kGouraud,
  kQuad,
  kQuadPolynomial,
  kQuadHorner,
  kQuadStep,
  kQuadMidpoint,
  kQuadThreeTerm,
  kQuadThirdDifference,
  kQuadSegment,
  kQuadDifference,
  kQuadFootprint,
  kQuadSplit,
  kQuadCosine,
  kPhongSurface,
  kPhong,
  kPhongTaylor,
  kPhongDuff,
  kSlerp,
  kSlerpPaper,
  kSlerpIntensity,
  kSlerpDirect,
  kAdaptive,
  kAdaptivePaper,
  kAdaptiveChord,
  kFootprint,
  kFootprintPaper,
  kAuto  // of a frame: each triangle has its own
};
inline constexpr int kMethodCount = 28;
inline constexpr std::array<std::string_view, kMethodCount> kMethodNames = {
    "flat", "gouraud", "quad", "quad-polynomial", "quad-horner", "quad-step", "quad-midpoint",
    "quad-three-term", "quad-third-difference", "quad-segment", "quad-difference",
    "quad-footprint", "quad-split", "quad-cosine", "phong-surface", "phong", "phong-taylor",
    "phong-duff", "slerp", "slerp-paper", "slerp-intensity", "slerp-direct", "adaptive",
    "adaptive-paper", "adaptive-chord", "footprint", "footprint-paper", "auto"};
inline constexpr std::string_view Name(Method method) {
  return kMethodNames[static_cast<size_t>(method)];
}
template <size_t kCount>
constexpr std::array<Method, kCount> FirstMethods() {
  std::array<Method, kCount> methods{};
  for (size_t i = 0; i < kCount; ++i) methods[i] = static_cast<Method>(i);
  return methods;
}
inline constexpr auto kAllMethods = FirstMethods<kMethodCount>();
// Methods that interpolate along a surface, by span_setup; the others interpolate normals.
inline constexpr auto kSurfaceMethods =
    FirstMethods<static_cast<size_t>(Method::kPhongSurface) + 1>();
constexpr bool InterpolatesNormals(Method method) {
  return method > Method::kPhongSurface && method < Method::kAuto;
}
// Of the former, those whose surfaces are of cosines.
constexpr bool InterpolatesCosines(Method method) {
  return method == Method::kQuadCosine || method == Method::kPhongSurface;
}
// N.L, N.H or N.V; phong-surface: |N|^2.
constexpr size_t CurvesOf(Method method) {
  return method == Method::kPhongSurface ? 3 : method == Method::kQuadCosine ? 2 : 0;
}
// Methods that light every pixel, kAuto where it has to; the others interpolate intensities.
constexpr bool LightsPixels(Method method) { return method >= Method::kQuadCosine; }
constexpr bool IsSpherical(Method method) {
  return method >= Method::kSlerp && method < Method::kAdaptiveChord;
}
// Methods whose normals come from adaptive_normalizer, not from recurrences of normal_setup.
constexpr bool IsAdaptive(Method method) {
  return method >= Method::kAdaptive && method <= Method::kAdaptiveChord;
}
// Methods that light several samples of a pixel and show their mean.
constexpr bool IsFootprint(Method method) {
  return method >= Method::kFootprint && method < Method::kAuto;
}
// Methods that show the surface of paper 003 (2) and differ in how they compute a row, and its
// mean.
constexpr bool IsQuadRow(Method method) {
  return method >= Method::kQuad && method <= Method::kQuadFootprint;
}
// Of these, the ones that evaluate the polynomial anew for every pixel.
constexpr bool IsPointForm(Method method) {
  return method == Method::kQuadPolynomial || method == Method::kQuadHorner;
}

}  // namespace shading
