// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/choice/choice_types.h"
#include "model/ideal/lighting.h"

namespace shading::accuracy {

// Coefficients of one channel, in parts of full scale, and what is left out.
struct ChoiceLight {
  double ambient = 0, diffuse = 0, specular = 0, shininess = 1;
  Lighting lighting = Lighting::kBlinn;
  bool dark = false, lightless = false;  // no highlight; nor diffuse light
};

// A triangle in the space of normals and a point of it: all that an error depends on.
struct ChoiceCase {
  std::array<ideal::Vector, 3> normal;       // unit
  ideal::Vector light, half_or_view;         // unit
  std::array<std::array<double, 3>, 2> end;  // barycentric: ends of a span
  double along = 0;                          // 0..1, where the point is on it

  std::array<double, 3> Weight() const;
};

// Light of the normalised linear normal at the point, in codes, not rounded.
double ExactCodes(const ChoiceLight& light, const ChoiceCase& at);

// What a method shows there, by its closed form in double:
//
//   flat          light of the normalised sum of the normals
//   gouraud       line through the light of the corners
//   quad          quadratic through the light of the corners and of the middles of the edges
//   quad-cosine   light of the quadratics through N.L and N.H or N.V
//   phong-surface, phong-duff   light of the normalised linear normal
double ShownCodes(Method method, const ChoiceLight& light, const ChoiceCase& at);

}  // namespace shading::accuracy
