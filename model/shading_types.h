// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "model/choice/choice_types.h"
#include "model/fixed/fixed.h"
#include "model/footprint/footprint_types.h"
#include "model/normal/normal_types.h"
#include "model/shading_method.h"

namespace shading {

// Twins of the typedefs in rtl/pkg/shading_pkg.sv: what each number means.
using Code = U<8, 0>;              // displayed intensity, round(255 I)
using Intensity = U<8, 16>;        // node value in codes (255 = full scale), 16 fraction bits
using SignedIntensity = S<9, 16>;  // a term of the light, not clamped
using IntensityAcc = S<9, 26>;     // intensity in codes for recurrences; wraps, see surface_fit
using Depth = U<0, 24>;            // [0, 1), smaller is nearer
using DepthAcc = S<1, 38>;         // depth with 14 guard bits, for the step along a span

using CosineAcc = S<1, 44>;  // cosine on a surface; wraps likewise
using Tolerance = U<4, 12>;  // codes

inline constexpr int kChannels = 3;  // red, green, blue
inline constexpr int kCurves = 3;    // N.L; N.H or N.V; phong-surface: |N|^2
inline constexpr int kMaxScreen = 4096;

// I(x, y) = A x^2 + B y^2 + C xy + D x + E y + F, paper 003 (2), in codes, one colour channel;
// x, y in pixels from the triangle's origin, -4095..4095. F carries the half code that makes
// truncation round.
template <typename Value>
struct BasicSurface {
  Value a, b, c, d, e, f;
};
using Surface = BasicSurface<IntensityAcc>;
using CosineSurface = BasicSurface<CosineAcc>;  // of an unclamped cosine or |N|^2; no half unit

// The surface of one channel and a pixel on it.
struct SurfacePoint {
  Surface surface;
  int x = 0, y = 0;
};

// What the shading unit keeps for one triangle.
struct TriangleState {
  int origin_x = 0, origin_y = 0;               // first pixel of its first span, where x = y = 0
  DepthAcc dz_dx;                               // depth step per pixel
  int material = 0;                             // methods that light every pixel
  LightRange range;                             // auto
  AngleLimit limit;                             // adaptive methods
  Footprint footprint;                          // footprint methods
  std::array<Surface, kChannels> surface;       // intensity; quad-split: diffuse, no half code
  std::array<Surface, kChannels> specular;      // quad-split, no half code
  std::array<IntensityAcc, kChannels> ambient;  // quad-split, with the half code
  std::array<CosineSurface, kCurves> curve;     // quad-cosine, phong-surface
};

// A run of pixels of one triangle on one scanline.
struct SpanCommand {
  int x = 0, y = 0;   // first pixel, on the screen
  int length = 0;     // pixels, 1..4096
  DepthAcc z;         // depth at the first pixel's centre, plus half an ulp of Depth
  bool last = false;  // last span of its triangle
  std::array<SpanNormal, 2> normal = {};  // at its first and last pixel; phong and slerp methods
  Margins margin = {};                    // at its first pixel; footprint-paper
};

// Row start, row start of the next pixel and differences of one channel: paper 003 (9), (3).
template <typename Value>
struct BasicSeed {
  Value first;       // I(0)
  Value second;      // I(stride); one pixel, or the number of lanes
  Value difference;  // I(stride) - I(0)
  Value curvature;   // stride^2 2A
};
using ChannelSeed = BasicSeed<IntensityAcc>;
using CurveSeed = BasicSeed<CosineAcc>;

struct SplitSeed {
  ChannelSeed specular;
  IntensityAcc ambient;
};

// What span_setup or normal_setup hands to the pixel stage.
struct SpanSeed {
  int x = 0, y = 0, length = 0;
  DepthAcc z, dz_dx;
  int material = 0;
  std::array<ChannelSeed, kChannels> channel;  // methods that interpolate intensities
  std::array<SplitSeed, kChannels> split;      // quad-split
  std::array<SurfacePoint, kChannels> point;   // quad-polynomial, quad-horner
  std::array<CurveSeed, kCurves> curve;        // quad-cosine, phong-surface
  NormalSeed normal;                           // methods that interpolate normals
};

// One pixel as it leaves the shading unit.
struct Pixel {
  uint16_t x = 0, y = 0;
  uint32_t z = 0;  // raw Depth
  uint8_t r = 0, g = 0, b = 0;
  uint8_t last = 0;  // last pixel of its span

  friend bool operator==(const Pixel& a, const Pixel& b) {
    return std::memcmp(&a, &b, sizeof(Pixel)) == 0;
  }
  friend bool operator!=(const Pixel& a, const Pixel& b) { return !(a == b); }
};
static_assert(sizeof(Pixel) == 12, "no padding: compared as bytes");

// A pixel and the cycle, counted from the acceptance of its frame, in which it left.
struct TimedPixel {
  Pixel pixel;
  int64_t cycle = 0;
};

}  // namespace shading
