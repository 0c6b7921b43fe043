// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ostream>

#include "model/ideal/lighting.h"

namespace shading {

// How gtest names it.
inline void PrintTo(Lighting lighting, std::ostream* out) {
  *out << (lighting == Lighting::kBlinn ? "Blinn" : "Phong");
}

}  // namespace shading

namespace shading::ideal {

inline Vector3 Quantised(const Vector& v) {
  const Vector unit = Normalised(v);
  return {NormalComponent::Round(unit[0]), NormalComponent::Round(unit[1]),
          NormalComponent::Round(unit[2])};
}

inline shading::Rgb Colour(double r, double g, double b) {
  return {Reflectance::Round(r), Reflectance::Round(g), Reflectance::Round(b)};
}

// Light from the upper right, the viewer in front; one material with three different channels.
inline FrameState TestFrame(Lighting lighting) {
  FrameState frame;
  const Vector light = Normalised({0.3, 0.4, 0.8}), view = {0, 0, 1};
  frame.light = Quantised(light);
  frame.view = Quantised(view);
  frame.half = Quantised(Sum(light, view));
  frame.lighting = lighting;
  frame.materials.push_back({Colour(0.125, 0, 0.0625), Colour(0.5, 0.625, 0),
                             Colour(0.25, 0.125, 0.75), Shininess::Round(24)});
  return frame;
}

inline TrianglePacket TestTriangle() {
  TrianglePacket triangle;
  triangle.x = {ScreenCoord::Round(10.25), ScreenCoord::Round(14.5), ScreenCoord::Round(90.75)};
  triangle.y = {ScreenCoord::Round(8.5), ScreenCoord::Round(70.25), ScreenCoord::Round(40.5)};
  triangle.n = {Quantised({0.2, 0.5, 1}), Quantised({-0.3, 0.1, 1}), Quantised({0.6, -0.2, 1})};
  return triangle;
}

}  // namespace shading::ideal
