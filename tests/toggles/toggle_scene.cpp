// SPDX-License-Identifier: Apache-2.0
#include "tests/toggles/toggle_scene.h"

#include <algorithm>
#include <cstdlib>

#include "model/choice/method_choice.h"
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

bool IsSure(const FrameWork& work, Method method) {
  return std::all_of(
      work.triangles.begin(), work.triangles.end(), [&](const TriangleState& triangle) {
        const ChoiceLimit& limit = work.limits[static_cast<size_t>(triangle.material)];
        const auto bounds = MethodChoice::BoundsOf(triangle.range, limit, work.light.lighting);
        return std::any_of(bounds.begin(), bounds.end(), [&](const MethodChoice::Bound& bound) {
          return bound.method == method && bound.allowed &&
                 MethodChoice::LogAdd(bound.diffuse, bound.specular) <= 0;
        });
      });
}

}  // namespace shading::test
