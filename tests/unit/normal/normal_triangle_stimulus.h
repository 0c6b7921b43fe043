// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "model/ideal/slerp.h"
#include "model/normal/span_normals.h"
#include "model/raster/span_walker.h"
#include "tests/unit/light/normal_stimulus.h"
#include "tests/unit/raster/packet_stimulus.h"

namespace shading {

using Interpolation = SpanNormals::Interpolation;

// A frame with a material, so that the ideal methods can be made for it.
inline FrameState SpanFrame(int width, int height) {
  FrameState frame = Screen(width, height);
  frame.materials.resize(1);
  return frame;
}

inline Vector3 Opposite(const Vector3& n) {
  return {NormalComponent::FromRaw(-n[0].raw()), NormalComponent::FromRaw(-n[1].raw()),
          NormalComponent::FromRaw(-n[2].raw())};
}

// Normals of a triangle: anywhere, near each other, equal, nearly or exactly opposed, on the axes.
inline std::array<Vector3, 3> AnyNormals(CornerGenerator* choice, std::mt19937& random) {
  const Vector3 n = RandomNormal(random), m = RandomNormal(random);
  const double spread = std::ldexp(1.0, static_cast<int>(-choice->Integer(0, 22)));
  const Vector3 x = Quantised(1, 0, 0), y = Quantised(0, 1, 0), z = Quantised(0, 0, 1);
  std::array<Vector3, 3> normals;
  switch (choice->Integer(0, 7)) {
    case 0: normals = {n, m, RandomNormal(random)}; break;
    case 1: normals = {n, n, n}; break;
    case 2: normals = {n, Near(Opposite(n), spread, random), m}; break;
    case 3: normals = {n, Opposite(n), choice->Integer(0, 1) ? n : m}; break;
    case 4: normals = {n, n, Near(Opposite(n), spread, random)}; break;
    case 5: normals = {x, y, choice->Integer(0, 1) ? z : Opposite(x)}; break;
    default: normals = {n, Near(n, spread, random), Near(n, spread, random)}; break;
  }
  if (choice->Integer(0, 1)) std::swap(normals[0], normals[2]);
  if (choice->Integer(0, 3) == 0) {  // as far from unit length as a packet may be
    for (NormalComponent& c : normals[1]) c = NormalComponent::FromRaw(c.raw() - c.raw() / 1024);
  }
  return normals;
}

// A triangle, its spans as SpanWalker left them, and with their normals.
struct Attached {
  TrianglePacket packet;
  TriangleGeometry geometry;
  DepthAcc dz_dx;
  std::vector<SpanCommand> whole, spans;
  int64_t splits = 0;

  // False when nothing is covered.
  bool Make(const TrianglePacket& triangle, const FrameState& frame, Interpolation how) {
    packet = triangle;
    whole.clear();
    if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return false;
    const Plane depth = TriangleSetup::DepthPlane(geometry, packet);
    dz_dx = DepthAcc::Wrap(static_cast<int64_t>(depth.dx));
    SpanWalker::Walk(geometry, depth, &whole);
    spans = whole;
    splits = SpanNormals::Attach(geometry, packet, how, 0, dz_dx, &spans);
    return !spans.empty();
  }
};

inline ideal::Vector RealOf(const SpanNormal& n) {
  return {n[0].ToReal(), n[1].ToReal(), n[2].ToReal()};
}

// Worst component, in ulp of S1.30.
inline double UlpsBetween(const SpanNormal& n, const ideal::Vector& expected) {
  double worst = 0;
  for (size_t c = 0; c < 3; ++c) {
    worst = std::max(worst, std::abs(std::ldexp(expected[c], SpanNormalComponent::kFraction) -
                                     static_cast<double>(n[c].raw())));
  }
  return worst;
}

}  // namespace shading
