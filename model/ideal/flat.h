// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/ideal/lighting.h"

namespace shading::ideal {

// Flat shading: one light for the triangle, that of the normalised sum of its normals. Where the
// sum is shorter than 2^-5 it is that of the first vertex.
class Flat {
 public:
  Flat(const FrameState& frame, const TrianglePacket& triangle) {
    const Vector first = ToReal(triangle.n[0]);
    const Vector sum = Sum(first, Sum(ToReal(triangle.n[1]), ToReal(triangle.n[2])));
    codes_ = Light(frame).Shade(MeanNormal(sum).value_or(first), MaterialOf(frame, triangle));
  }

  Rgb At(double /*x*/, double /*y*/) const { return codes_; }

 private:
  Rgb codes_;
};

}  // namespace shading::ideal
