// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/ideal/barycentric.h"
#include "model/ideal/lighting.h"

namespace shading::ideal {

// Phong shading, the picture that the other methods approach: N = sum lam_i N_i, normalised and lit
// at every pixel. Where opposed normals cancel exactly N is zero and only the ambient light is
// left.
template <Vector (*Normalize)(const Vector&)>
class LinearNormalPhong {
 public:
  LinearNormalPhong(const FrameState& frame, const TrianglePacket& triangle)
      : barycentric_(triangle), light_(frame), material_(MaterialOf(frame, triangle)) {
    for (size_t i = 0; i < normal_.size(); ++i) normal_[i] = ToReal(triangle.n[i]);
  }

  Rgb At(double x, double y) const {
    const Barycentric::Weights weight = barycentric_.At(x, y);
    Vector normal = {};
    for (size_t i = 0; i < normal_.size(); ++i) {
      normal = Sum(normal, Scaled(weight[i], normal_[i]));
    }
    return light_.Shade(Normalize(normal), material_);
  }

 private:
  Barycentric barycentric_;
  Light light_;
  Material material_;
  std::array<Vector, 3> normal_;
};

using Phong = LinearNormalPhong<Normalised>;

// Lyon's three terms of Taylor's series for 1 / |N| about 1, paper 000: short normals stay short.
inline Vector NormalisedByTaylor(const Vector& v) {
  const double excess = Dot(v, v) - 1;
  return Scaled(1 - excess / 2 + 3 * excess * excess / 8, v);
}
using PhongTaylor = LinearNormalPhong<NormalisedByTaylor>;

}  // namespace shading::ideal
