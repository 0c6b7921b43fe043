// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/raster/triangle_setup.h"

namespace shading {

// Stage 1 of paper 000: the normals at the two ends of every span, at the centres of its first and
// last pixel.
//
//   kLinear      N = sum lambda_i N_i, not normalised, N_i as in the packet: a plane a component,
//                48 fraction bits modulo 2^64, counted from a covered pixel. 0.516 ulp.
//   kSpherical   unit N_i, slerp along the left and the right edge to the row's centre line,
//                slerp between them along the row: paper 000 (2). Edges step by (7), one step a
//                row.
//
// Spherical spans of more than 90 degrees are split in the middle, which is their bisector, so that
// each part has at most 90.
//
// No bad input: zero normals count as (0, 0, 1), opposed ones turn through a fixed direction, see
// SphereArc. Beyond 170 degrees the error is at most 0.5 + 2^-7 / |Nl + Nr| ulp.
class SpanNormals {
 public:
  static constexpr UnitContract kContract = {
      "span_normals",
      "normal",
      0,
      0,
      "vertices S13.8, normals S1.22, spans U12.0",
      "normals S1.30",
      0.6,
      "components; spherical: normals of an edge and of a row up to 170 degrees apart"};

  enum class Interpolation { kLinear, kSpherical };

  // Fills the normals of the spans from index first_span on, which SpanWalker appended for this
  // triangle; dz_dx is for the depth of split spans. Returns the number of spans that it split.
  static int64_t Attach(const TriangleGeometry& geometry, const TrianglePacket& packet,
                        Interpolation interpolation, size_t first_span, DepthAcc dz_dx,
                        std::vector<SpanCommand>* spans);
};

}  // namespace shading
