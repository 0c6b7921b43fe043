// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "model/light/light_types.h"
#include "model/shading_types.h"

namespace shading::accuracy {

inline constexpr std::array<Method, 7> kStudiedMethods = {
    Method::kPhong,      Method::kPhongTaylor,    Method::kPhongDuff,  Method::kSlerp,
    Method::kSlerpPaper, Method::kSlerpIntensity, Method::kSlerpDirect};

// A method of normal interpolation as it is built.
struct Configuration {
  Method method = Method::kSlerp;
  int lanes = 1;                            // 1 or 4
  int fraction_bits = Quantity::kFraction;  // of slerp-paper
  AngleLimit limit = {};                    // of the adaptive methods
};
std::string NameOf(const Configuration& configuration);

// One span under one light.
struct SpanCase {
  std::array<SpanNormal, 2> normal = {};  // at its first and last pixel
  Vector3 direction = {};                 // both L and H
  int length = 0;                         // pixels
};

// Cosines of every pixel as the bit-exact model has them, from normal_setup to the inputs of
// pixel_light. Spherical spans of more than 90 degrees are cut in two as span_normals does.
void ModelCosines(const Configuration& configuration, const SpanCase& span,
                  std::vector<LightCosines>* cosines);

}  // namespace shading::accuracy
