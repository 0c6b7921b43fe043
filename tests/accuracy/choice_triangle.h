// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "model/choice/method_choice.h"
#include "tests/accuracy/choice_search.h"

namespace shading::accuracy {

// A triangle, a light and a point as the hardware has them, and what methods show there.
class ChoiceTriangle {
 public:
  ChoiceTriangle(const ChoicePoint& point, Lighting lighting)
      : ChoiceTriangle(point.Case(), point.shininess, lighting) {}
  ChoiceTriangle(const ChoiceCase& at, double shininess, Lighting lighting);

  const LightRange& range() const { return range_; }
  Shininess shininess() const { return shininess_; }

  // Codes of the first channel, not rounded; |what the choice shows - exact|.
  double Shown(const Choice& choice, const Material& material) const;
  double Error(const Choice& choice, const Material& material) const;
  // N.H or R.V of the normalised linear normal at the point.
  double SpecularCosine() const;

 private:
  ChoiceCase case_;
  Lighting lighting_;
  Shininess shininess_;
  LightRange range_;
};

// Grey materials.
Material PlainMaterial(double ambient, double diffuse, double specular, double shininess);
Material WithShininess(Material material, Shininess shininess);
// From faint to full scale, some beyond it, some without one of the terms.
Material RandomMaterial(std::mt19937& random);

// The triangle on the other side of the edge that the point is on: another normal opposite.
ChoiceCase NeighborOf(ChoiceCase at, std::mt19937& random);

// The most of the tolerance that a chosen method takes, on pixels, or doubled on edges: the worst
// that a search finds over `materials` materials and all that ChoiceSearch moves.
double WorstShare(Method method, Lighting lighting, double tolerance, bool edge, int materials);

}  // namespace shading::accuracy
