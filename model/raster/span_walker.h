// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/raster/triangle_setup.h"

namespace shading {

// Finds the spans of a triangle, row by row: exactly the pixels whose three edge functions are
// inside by the top-left rule. No pixel twice and none missing on shared edges.
//
// Each edge bounds the row on one side at the pixel floor(n / d); n moves by a constant from row to
// row, so quotient and remainder are stepped by additions (two divisions an edge, none a row).
class SpanWalker {
 public:
  static constexpr UnitContract kContract = {"span_walker", "raster", 0, 0,
                                             "edge functions, 2^-16 square pixels",
                                             "spans U12.0, depth S1.38", 0, "any triangle"};

  // Appends the spans, the last one marked; returns the number of their pixels.
  static int64_t Walk(const TriangleGeometry& geometry, const Plane& depth,
                      std::vector<SpanCommand>* spans);
};

}  // namespace shading
