// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "model/ideal/barycentric.h"
#include "model/ideal/lighting.h"
#include "model/ideal/quadratic.h"

namespace shading::ideal {

// The points whose mean stands for a disc on the screen: rings of equal area, as many spokes.
struct Disc {
  // The second moments of the square pixel.
  static constexpr double kPixel = 0.57735026918962576;

  double radius = kPixel;
  int rings = 64;

  // Small enough to span at most half a barycentric of the triangle.
  static Disc Within(const TrianglePacket& triangle, int rings);

  // Points of equal area, from the centre.
  using Points = std::vector<std::array<double, 2>>;
  Points Offsets() const;
};

// A pixel's light as the mean over its footprint, paper 001, by brute force: 4096 points of the
// ellipse, each with its own barycentrics, normal and light.
//
// The ellipse is where the pixel's disc falls on the surface; equal areas of one are equal areas of
// the other without perspective, and to first order with it. The disc has the second moments of the
// square pixel: radius 1/sqrt(3).
class Footprint {
 public:
  static constexpr double kRadius = Disc::kPixel;
  static constexpr int kRings = Disc{}.rings, kSpokes = kRings;

  // Distances of the vertices from the viewer; nothing without perspective.
  using Distances = std::optional<std::array<double, 3>>;

  Footprint(const FrameState& frame, const TrianglePacket& triangle,
            const Distances& distances = {}, const Disc& disc = {});

  // Not normalised; of the triangle's plane, also outside the triangle.
  Vector Normal(double x, double y) const;
  // Light of the mean of the diffuse factor and the highlight.
  Rgb At(double x, double y) const;

 private:
  Disc::Points points_;
  Barycentric barycentric_;
  Light light_;
  Material material_;
  std::array<Vector, 3> normal_;
};

// The mean of the quadratic surface of paper 003.
class QuadraticFootprint {
 public:
  QuadraticFootprint(const FrameState& frame, const TrianglePacket& triangle)
      : points_(Disc::Within(triangle, 16).Offsets()), quadratic_(frame, triangle) {}

  Rgb At(double x, double y) const;

 private:
  Disc::Points points_;
  Quadratic quadratic_;
};

// The paper's form: normals from the enlarged triangle A' = 2A - C, B' = 2B - A, C' = 2C - B with
// (5), N_B' = 2 (N_A.N_B) N_B - N_A; what lies outside it, (3), does not count.
class PaperFootprint {
 public:
  PaperFootprint(const FrameState& frame, const TrianglePacket& triangle,
                 const Footprint::Distances& distances = {}, const Disc& disc = {});

  Barycentric::Weights Weights(double column, double row) const;  // in the enlarged triangle
  Vector Normal(double x, double y) const;
  // (3): the unsigned areas add up to more than the triangle.
  bool Outside(double x, double y) const;
  // The largest angle between two enlarged normals passes 90 degrees.
  bool Subdivides() const;
  Rgb At(double x, double y) const;

 private:
  Disc::Points points_;
  Barycentric barycentric_;
  Light light_;
  Material material_;
  std::array<double, 3> near_;   // 1 / distance of a vertex
  std::array<double, 3> x_, y_;  // enlarged corners of the triangle (0, 0), (1, 0), (0, 1)
  std::array<Vector, 3> normal_;
};

}  // namespace shading::ideal
