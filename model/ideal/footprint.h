// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "model/ideal/barycentric.h"
#include "model/ideal/lighting.h"

namespace shading::ideal {

// A pixel's light as the mean over its footprint, paper 001, by brute force: 4096 points of the
// ellipse, each with its own barycentrics, normal and light.
//
// The ellipse is where the pixel's disc falls on the surface; equal areas of one are equal areas of
// the other without perspective, and to first order with it. The disc has the second moments of the
// square pixel: radius 1/sqrt(3).
class Footprint {
 public:
  static constexpr double kRadius = 0.57735026918962576;
  static constexpr int kRings = 64, kSpokes = 64;

  // Distances of the vertices from the viewer; nothing without perspective.
  using Distances = std::optional<std::array<double, 3>>;

  Footprint(const FrameState& frame, const TrianglePacket& triangle,
            const Distances& distances = {});

  // Not normalised; of the triangle's plane, also outside the triangle.
  Vector Normal(double x, double y) const;
  // Light of the mean of the diffuse factor and the highlight.
  Rgb At(double x, double y) const;

 private:
  Barycentric barycentric_;
  Light light_;
  Material material_;
  std::array<Vector, 3> normal_;
};

// The paper's form: normals from the enlarged triangle A' = 2A - C, B' = 2B - A, C' = 2C - B with
// (5), N_B' = 2 (N_A.N_B) N_B - N_A; what lies outside it, (3), does not count.
class PaperFootprint {
 public:
  PaperFootprint(const FrameState& frame, const TrianglePacket& triangle);

  Barycentric::Weights Weights(double x, double y) const;  // in the enlarged triangle
  Vector Normal(double x, double y) const;
  // (3): the unsigned areas add up to more than the triangle.
  bool Outside(double x, double y) const;
  // The largest angle between two enlarged normals passes 90 degrees.
  bool Subdivides() const;
  Rgb At(double x, double y) const;

 private:
  Light light_;
  Material material_;
  std::array<double, 3> x_, y_;
  std::array<Vector, 3> normal_;
};

}  // namespace shading::ideal
