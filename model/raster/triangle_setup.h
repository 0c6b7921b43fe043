// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/shading_types.h"
#include "model/triangle_packet.h"
#include "model/unit_contract.h"

namespace shading {

// Edge function opposite corner i, in units of 2^-16 square pixels, at pixel centres counted from
// the corner of the bounding box: w(x, y) = w0 + x dx + y dy, positive inside.
struct Edge {
  int64_t w0 = 0;
  int64_t dx = 0;
  int64_t dy = 0;
  bool top_left = false;  // pixels with w = 0 belong to the triangle
};

// A quantity that is affine on the triangle: value(x, y) = at_origin + x dx + y dy. 33 fraction
// bits for barycentrics, 38 for depth; kept modulo 2^64, as two's complement.
struct Plane {
  uint64_t at_origin = 0, dx = 0, dy = 0;

  uint64_t At(int x, int y) const {
    return at_origin + static_cast<uint64_t>(x) * dx + static_cast<uint64_t>(y) * dy;
  }
};

// A triangle that may cover pixels, turned so that its area is positive with y running down.
struct TriangleGeometry {
  std::array<int, 3> corner;  // vertex of the packet that stands at each corner
  int64_t area = 0;           // twice the area, in units of 2^-16 square pixels
  int box_x = 0, box_y = 0;   // bounding box of pixel centres, clipped to the screen
  int columns = 0, rows = 0;
  std::array<Edge, 3> edge;
};

enum class Verdict { kDraw, kBackFacing, kDegenerate, kOffScreen, kEmpty };

// Triangle set-up, integers only: edge functions with the top-left rule, scissor, culling, and the
// planes of the barycentrics and of the depth.
//
// Pixel (i, j) is sampled at (i + 1/2, j + 1/2). Vertices are S13.8 pixels. The barycentrics'
// planes are rounded to 2^-34: corners 0 and 1 at most 2^-21 off anywhere on a
// 4096 x 4096 screen, corner 2 at most 2^-20. The depth plane
// counts from the corner of the bounding box and is rounded to 2^-39, with half an ulp of U0.24
// added: at most 1/4 ulp off.
class TriangleSetup {
 public:
  static constexpr UnitContract kContract = {
      "triangle_setup",
      "raster",
      0,
      0,
      "vertices S13.8, depth U0.24",
      "barycentric planes S1.33, depth plane S1.38",
      0.25,
      "depth in ulp of U0.24 on screens of 4096 x 4096 pixels, before rounding"};
  static constexpr int kBarycentricFraction = 33;

  static Verdict Setup(const TrianglePacket& packet, const FrameState& frame,
                       TriangleGeometry* geometry);
  // Planes of corners 0 and 1, counted from pixel (x, y) of the screen; corner 2 has 1 minus their
  // sum, so that the three add up to 1. A covered pixel keeps the values there in [0, 1], however
  // thin the triangle.
  static std::array<Plane, 3> Barycentrics(const TriangleGeometry& geometry, int x, int y);
  static Plane DepthPlane(const TriangleGeometry& geometry, const TrianglePacket& packet);
};

}  // namespace shading
