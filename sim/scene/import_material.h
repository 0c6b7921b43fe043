// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <assimp/material.h>

#include "sim/scene/scene.h"

namespace shading::sim {

// Coefficients of an imported material, colours clamped to 0..1 and shininess to 1..256.
// - Classic (MTL and alike): Ka, Kd, Ks, Ns as they are; a missing Ka or Ks is black. Ka = 1 1 1 is
//   what exporters write when they know no ambient term and would bleach the picture: it becomes a
//   tenth of Kd.
// - glTF metallic-roughness: diffuse = base colour, ambient a tenth of it,
//   specular = (0.04 + metallic (base - 0.04)) (1 - roughness), n = 2 / roughness^4 - 2. The factor
//   (1 - roughness) lowers the peak of a wide highlight, which would clip on top of the diffuse
//   term. With specular-glossiness the file's specular colour is taken and roughness is
//   1 - glossiness.
// - The placeholder that assimp makes up for a mesh without a material: SceneMaterial's defaults.
// Throws std::runtime_error without a file name if a coefficient is not finite.
SceneMaterial ConvertMaterial(const aiMaterial& source);

}  // namespace shading::sim
