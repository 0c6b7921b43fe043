// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

#include "sim/scene/scene.h"

namespace shading::sim {

inline constexpr int kMaxSubdivision = 2048;

struct BuiltinScene {
  const char* name;
  const char* description;
  int default_n;  // subdivision when the name stands alone
  int min_n;
};

inline constexpr std::array<BuiltinScene, 7> kBuiltinScenes = {{
    {"triangle", "one large triangle with tilted vertex normals, in N x N parts", 1, 1},
    {"sphere", "plastic sphere, N latitude bands of 2N quads", 16, 2},
    {"torus", "tilted torus, N rings of N sides", 32, 3},
    {"saddle", "patch z = x y / 2, N x N quads", 12, 1},
    {"panel", "flat glossy panel whose normals bulge by 20 degrees, N x N quads", 16, 1},
    {"cylinder", "glossy open cylinder along y, N sides of N quads", 24, 3},
    {"mixed", "plastic and glossy spheres, matte torus, brass saddle; N as in sphere", 16, 3},
}};

// The scene "NAME", "NAME:N" or the same after "builtin:". Throws std::runtime_error for an unknown
// name or an N outside min_n..kMaxSubdivision.
Scene MakeBuiltin(const std::string& spec);

}  // namespace shading::sim
