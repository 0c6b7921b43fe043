// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "model/ideal/barycentric.h"
#include "model/ideal/lighting.h"

namespace shading::ideal {

// Paper 003 (2) for kCount values at once, in barycentric form: the quadratic through the values of
// the three vertices and of the three middles of the edges, whose normals are bisections, paper 002
// (1). A middle of opposed normals has the mean of its ends.
template <size_t kCount>
class NodeSurface {
 public:
  using Values = std::array<double, kCount>;

  // values(normal) are those of a unit normal.
  template <typename ValuesOf>
  NodeSurface(const TrianglePacket& triangle, const ValuesOf& values) : barycentric_(triangle) {
    for (size_t i = 0; i < 3; ++i) vertex_[i] = values(ToReal(triangle.n[i]));
    for (size_t opposite = 0; opposite < 3; ++opposite) {
      const size_t i = (opposite + 1) % 3, j = (opposite + 2) % 3;
      excess_[opposite] = {};
      const auto normal = MeanNormal(Sum(ToReal(triangle.n[i]), ToReal(triangle.n[j])));
      if (!normal) continue;
      const Values middle = values(*normal);
      for (size_t v = 0; v < kCount; ++v) {
        excess_[opposite][v] = middle[v] - (vertex_[i][v] + vertex_[j][v]) / 2;
      }
    }
  }

  Values At(double x, double y) const {
    const Barycentric::Weights weight = barycentric_.At(x, y);
    Values sum = {};
    for (size_t i = 0; i < 3; ++i) {
      const double bump = 4 * weight[(i + 1) % 3] * weight[(i + 2) % 3];
      for (size_t v = 0; v < kCount; ++v)
        sum[v] += weight[i] * vertex_[i][v] + bump * excess_[i][v];
    }
    return sum;
  }

 private:
  Barycentric barycentric_;
  std::array<Values, 3> vertex_, excess_;
};

// quad-split: surfaces of kd (N.L), not clamped, and of ks (N.H)^n, each clamped at 0 and added.
class QuadSplit {
 public:
  QuadSplit(const FrameState& frame, const TrianglePacket& triangle)
      : light_(frame),
        material_(MaterialOf(frame, triangle)),
        surface_(triangle, [this](const Vector& normal) {
          const Light::Terms terms = light_.TermsOf(light_.CosinesOf(normal), material_);
          return std::array<double, 6>{terms.diffuse[0],  terms.diffuse[1],  terms.diffuse[2],
                                       terms.specular[0], terms.specular[1], terms.specular[2]};
        }) {}

  Rgb At(double x, double y) const {
    const auto values = surface_.At(x, y);
    const Rgb ambient = light_.TermsOf({}, material_).ambient;
    Rgb codes;
    for (size_t c = 0; c < codes.size(); ++c) {
      codes[c] = ambient[c] + std::max(values[c], 0.0) + std::max(values[c + 3], 0.0);
    }
    return Clamped(codes);
  }

 private:
  Light light_;
  Material material_;
  NodeSurface<6> surface_;
};

// quad-cosine: surfaces of N.L and of N.H or N.V, neither clamped; light of them at every point.
class QuadCosine {
 public:
  QuadCosine(const FrameState& frame, const TrianglePacket& triangle)
      : light_(frame),
        material_(MaterialOf(frame, triangle)),
        surface_(triangle, [this](const Vector& normal) {
          const Light::Cosines cosines = light_.CosinesOf(normal);
          return std::array<double, 2>{cosines.n_dot_l, cosines.n_dot_h_or_v};
        }) {}

  Rgb At(double x, double y) const {
    const auto values = surface_.At(x, y);
    return light_.ShadeCosines({values[0], values[1]}, material_);
  }

 private:
  Light light_;
  Material material_;
  NodeSurface<2> surface_;
};

}  // namespace shading::ideal
