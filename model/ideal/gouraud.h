// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/ideal/barycentric.h"
#include "model/ideal/lighting.h"

namespace shading::ideal {

// Gouraud shading: I = sum lam_i I_i, with the clamped light of the vertices' own normals.
class Gouraud {
 public:
  Gouraud(const FrameState& frame, const TrianglePacket& triangle) : barycentric_(triangle) {
    const Light light(frame);
    for (size_t i = 0; i < vertex_.size(); ++i) {
      vertex_[i] = light.Shade(ToReal(triangle.n[i]), MaterialOf(frame, triangle));
    }
  }

  Rgb At(double x, double y) const {
    const Barycentric::Weights weight = barycentric_.At(x, y);
    Rgb codes = {};
    for (size_t i = 0; i < vertex_.size(); ++i) codes = Sum(codes, Scaled(weight[i], vertex_[i]));
    return codes;
  }

  const Rgb& vertex(size_t i) const { return vertex_[i]; }

 private:
  Barycentric barycentric_;
  std::array<Rgb, 3> vertex_;
};

}  // namespace shading::ideal
