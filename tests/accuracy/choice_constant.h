// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/accuracy/choice_search.h"

namespace shading::accuracy {

// One constant of method_choice: the error of a method in one kind of light.
struct ChoiceConstant {
  enum class Light { kLit, kTerminator, kHighlight };

  Method method;
  Light light;
  Lighting lighting = Lighting::kBlinn;
  int highlight = 0;  // k: at most 2^-k of the highlight falls on the triangle; 15: or less
};

struct ChoiceEffort {
  int restarts, steps;
};

// log2 of the worst error that a search finds, or of twice that on an edge, over what the constant
// is multiplied with: see docs/units/choice/method_choice.md. Directed at its k; any turn up to 60
// degrees, any n.
double WorstConstant(const ChoiceConstant& constant, const ChoiceEffort& effort);

// Largest angles between normals, in degrees, for full-scale light of one kind and 1 code: that
// MethodChoice allows wherever the highlight is, and where the worst error that a search finds, or
// twice that on an edge, is 1 code. n = 0 stands for diffuse light. 0.0006 stands for none.
double AllowedDegrees(Method method, int shininess);
double SearchedDegrees(Method method, int shininess, const ChoiceEffort& effort);

}  // namespace shading::accuracy
