// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "model/triangle_packet.h"

namespace shading::test {

// The words SCENE [SIZE] of a command line: builtin:NAME or a mesh file, on SIZE x SIZE pixels, 96
// when not given: small, as every bit of every cycle is looked at. Throws std::runtime_error as
// MakeBuiltin, ImportMesh and Project do.
struct ToggleScene {
  std::string name;
  TriangleList list;
};
ToggleScene SceneOf(int argc, char** argv);

// main() of a tool that prints something of the scene: 1 and a line on stderr when it throws.
int PrintScene(const char* tool, int argc, char** argv,
               void (*print)(const std::string& scene, const TriangleList& list));

}  // namespace shading::test
