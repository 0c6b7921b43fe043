// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "model/fixed/wide_integer.h"
#include "model/raster/triangle_setup.h"
#include "sim/stress/check.h"

namespace shading::stress {

// The first operands of units that set up triangles: where its vertices lie.
inline const std::vector<std::string> kCorners = {
    "kind: guard band, whole screen, sliver, small, whole sliver",
    "x0",
    "y0",
    "x1",
    "y1",
    "x2",
    "y2"};

// A frame without culling with one grey material, light and viewer in front.
FrameState FrameOf(int width, int height);

// Vertices of a triangle for a screen, in the guard band of +-8191 pixels: anywhere; two beyond
// opposite corners of the screen; two anywhere or so and the third within 3/256 pixel of the line
// between them; or all within 64 pixels.
TrianglePacket CornersOf(const Genes& genes, int width, int height);

// `count` normals from two operands each.
std::array<Vector3, 3> NormalsOf(const Genes& genes, size_t first);
inline const std::vector<std::string> kNormals = {"N0, turn",   "N0, height", "N1, turn",
                                                  "N1, height", "N2, turn",   "N2, height"};

// Normals of a triangle: the second and third any way from the first, even in the
// logarithm; `opposed`: the second from its opposite.
inline const std::vector<std::string> kNear = {"N0, turn",
                                               "N0, height",
                                               "N1 - N0, 2^(1 - 24 g)",
                                               "its direction, turn",
                                               "its height",
                                               "N2 - N0, 2^(1 - 24 g)",
                                               "its direction, turn",
                                               "its height"};
std::array<Vector3, 3> NearNormals(const Genes& genes, size_t first, bool opposed = false);

// Twice the area and the weight of each vertex times it, in exact integers from the definition:
// units of 2^-16 square pixels; the sign makes the area positive.
class ExactWeights {
 public:
  explicit ExactWeights(const TrianglePacket& packet);
  Int128 area() const { return area_; }
  // At the centre of a pixel.
  Int128 At(size_t vertex, int x, int y) const;
  // Change of the weight from pixel to pixel.
  Int128 Dx(size_t vertex) const { return At(vertex, 1, 0) - At(vertex, 0, 0); }
  Int128 Dy(size_t vertex) const { return At(vertex, 0, 1) - At(vertex, 0, 0); }
  // The top-left rule, as a centre that is moved right, and by far less down.
  bool Covers(int x, int y) const;
  // Covered pixels [first, second) of a row of `columns` pixels from `left`.
  std::array<int, 2> Row(int y, int left, int columns) const;

 private:
  std::array<std::array<int64_t, 2>, 3> corner_;
  int sign_ = 1;
  Int128 area_ = 0;
};

// Covered pixels far from one another: ends of the first rows, of the last, and of some between;
// the very first pixel, from which planes count, first. Empty when nothing is covered.
std::vector<std::array<int, 2>> FarPixels(const ExactWeights& weights,
                                          const TriangleGeometry& geometry);

}  // namespace shading::stress
