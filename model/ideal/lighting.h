// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "model/triangle_packet.h"

namespace shading::ideal {

using Vector = std::array<double, 3>;
using Rgb = std::array<double, 3>;  // codes, 255 = full scale, not rounded

Vector ToReal(const shading::Vector3& v);
double Dot(const Vector& a, const Vector& b);
Vector Sum(const Vector& a, const Vector& b);
Vector Scaled(double factor, const Vector& v);
Vector Normalised(const Vector& v);  // zero stays zero

// Paper 002 (1): the direction half way between normals; nullopt where the sum is shorter than
// 2^-5, for there the quantised normals no longer tell it.
std::optional<Vector> MeanNormal(const Vector& sum);

// Throws std::out_of_range when the frame has no such material.
inline const Material& MaterialOf(const FrameState& frame, const TrianglePacket& triangle) {
  return frame.materials.at(static_cast<size_t>(triangle.material));
}

// Within 0..255.
Rgb Clamped(const Rgb& codes);

// Paper 000 (1), (12) with light and viewer at infinity:
//
//   I = ka + kd (N.L) + ks (N.H)^n                                  Lighting::kBlinn
//   I = ka + kd (N.L) + ks (R.V)^n,  R = 2 (N.L) N - L                       kPhong
//
// cosines clamped to [0, 1], I clamped to 1. N counts as it is, unit or not.
class Light {
 public:
  explicit Light(const FrameState& frame);

  Rgb Shade(const Vector& normal, const Material& material) const;

  // N.L, and N.H or N.V: linear in the normal.
  struct Cosines {
    double n_dot_l = 0, n_dot_h_or_v = 0;
  };
  Cosines CosinesOf(const Vector& normal) const;
  // Shade from the cosines.
  Rgb ShadeCosines(const Cosines& cosines, const Material& material) const;
  // ka; kd (N.L), not clamped; ks (N.H)^n or ks (R.V)^n.
  struct Terms {
    Rgb ambient, diffuse, specular;
  };
  Terms TermsOf(const Cosines& cosines, const Material& material) const;
  // With N.L clamped to 0..1 in the diffuse term; R.V has it as it is.
  Terms LitTermsOf(const Cosines& cosines, const Material& material) const;

 private:
  double SpecularCosine(const Cosines& cosines) const;

  Lighting lighting_;
  Vector light_, half_, view_;
};

}  // namespace shading::ideal
