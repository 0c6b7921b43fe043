// SPDX-License-Identifier: Apache-2.0
#include "tests/toggles/toggle_scene.h"

#include <fmt/format.h>

#include <cstdlib>
#include <exception>

#include "sim/scene/builtin.h"
#include "sim/scene/camera.h"
#include "sim/scene/import.h"

namespace shading::test {

ToggleScene SceneOf(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "builtin:mixed:8";
  sim::ViewOptions view;
  view.width = view.height = argc > 2 ? std::atoi(argv[2]) : 96;
  const sim::Scene scene =
      name.rfind("builtin:", 0) == 0 ? sim::MakeBuiltin(name) : sim::ImportMesh(name);
  return {name, sim::Project(scene, view)};
}

int PrintScene(const char* tool, int argc, char** argv,
               void (*print)(const std::string& scene, const TriangleList& list)) {
  try {
    const ToggleScene scene = SceneOf(argc, argv);
    print(scene.name, scene.list);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", tool, error.what());
    return 1;
  }
  return 0;
}

}  // namespace shading::test
