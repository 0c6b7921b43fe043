// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/quadratic.h"

namespace shading::ideal {

Quadratic::Quadratic(const FrameState& frame, const TrianglePacket& triangle)
    : barycentric_(triangle), linear_(frame, triangle) {
  const Light light(frame);
  for (size_t opposite = 0; opposite < excess_.size(); ++opposite) {
    const size_t i = (opposite + 1) % 3, j = (opposite + 2) % 3;
    const auto normal = MeanNormal(Sum(ToReal(triangle.n[i]), ToReal(triangle.n[j])));
    excess_[opposite] = {};
    if (!normal) continue;
    const Rgb straight = Scaled(0.5, Sum(linear_.vertex(i), linear_.vertex(j)));
    excess_[opposite] =
        Sum(light.Shade(*normal, MaterialOf(frame, triangle)), Scaled(-1, straight));
  }
}

Rgb Quadratic::AtUnclamped(double x, double y) const {
  const Barycentric::Weights weight = barycentric_.At(x, y);
  Rgb codes = linear_.At(x, y);
  for (size_t opposite = 0; opposite < excess_.size(); ++opposite) {
    const double bump = 4 * weight[(opposite + 1) % 3] * weight[(opposite + 2) % 3];
    codes = Sum(codes, Scaled(bump, excess_[opposite]));
  }
  return codes;
}

}  // namespace shading::ideal
