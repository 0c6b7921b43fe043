// SPDX-License-Identifier: Apache-2.0
//
// Flicker of slanted scenes that turn, as the table of docs/footprint.md.
// Usage: footprint_flicker [PICTURE.png]
#include <fmt/format.h>

#include <exception>

#include "tests/accuracy/footprint_flicker.h"

int main(int argc, char** argv) {
  using namespace shading::accuracy;
  constexpr int kShownFrame = 30;
  try {
    const auto scenes = SlantedScenes();
    if (argc > 1) {
      const auto picture = FlickerPicture({scenes[0], scenes[1]}, kShownFrame);
      shading::sim::WriteImage(argv[1], picture);
    }
    for (const Turning& scene : scenes) {
      const FlickerTable table = MeasureFlicker(scene, kTurningSteps);
      for (size_t d = 0; d < kDrawings; ++d) {
        fmt::print("| {} | {} | {:.3f} | {:.3f} | {:.3f} |\n", scene.name, kDrawingName[d],
                   table[d].change, table[d].beyond_ellipse, table[d].beyond_sampled);
      }
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "footprint_flicker: {}\n", error.what());
    return 2;
  }
  return 0;
}
