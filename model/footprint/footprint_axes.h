// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "model/fixed/wide_integer.h"
#include "model/raster/triangle_setup.h"

namespace shading {

// Change of a vector that is affine on the screen: numerators over the triangle's area, the edge
// functions' units times the vector's.
struct Slope {
  std::array<int64_t, 3> dx, dy;
};

// Edge functions by vertex of the packet.
std::array<Edge, 3> EdgesByVertex(const TriangleGeometry& geometry);

// The ellipse that the direction of the normal draws while the pixel's disc is walked through: its
// axes are those of J'J, J = d(normal)/d(screen) without the part along the normal.
//
// Direction of the major axis on the screen, unit length, S1.30; the minor axis is (-y, x). (1, 0)
// for a circle and where normals cancel.
struct FootprintAxes {
  int64_t x = int64_t{1} << 30, y = 0;

  static FootprintAxes Of(const Slope& slope, const std::array<int64_t, 3>& normal);
};

// How far a disc on the screen reaches in units of a slope's vector: value = numerator / divisor.
//
// Radius 1/sqrt(3) pixels: the disc has the second moments of the square pixel. Where that spans
// more than `limit` of a barycentric, a smaller disc that does not: what lies farther from a sliver
// is not its surface.
class FootprintReach {
 public:
  static constexpr int kFraction = 30;
  static constexpr int64_t kRadius = 619925131;  // 2^30 / sqrt(3)

  FootprintReach(const std::array<Edge, 3>& edge, int64_t area, int64_t limit_halves);

  // The change from the centre to the end of an axis (x, y), S1.30, with `fraction` fraction bits,
  // of a slope of `slope_fraction`; rounded to nearest.
  std::array<int64_t, 3> Along(const Slope& slope, int64_t x, int64_t y, int slope_fraction,
                               int fraction) const;

 private:
  Int128 numerator_, divisor_;
};

}  // namespace shading
