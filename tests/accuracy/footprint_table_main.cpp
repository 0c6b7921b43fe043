// SPDX-License-Identifier: Apache-2.0
//
// Prints the tables of docs/footprint.md: footprint_table [--quick].
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "tests/accuracy/footprint_plane.h"
#include "tests/accuracy/footprint_raster.h"
#include "tests/accuracy/footprint_seam.h"
#include "tests/accuracy/spread_text.h"

namespace shading::accuracy {
namespace {

constexpr std::array<int, kFootprintPatterns> kSamples = {1, 2, 4, 8};

void PrintPlane(int grid) {
  fmt::print("| axes | n | turn | 1 | 2 | 4 | 8 | taken |\n|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const double ratio : {1., 2., 4., 8., 16.}) {
    for (const int n : {1, 8, 32, 128}) {
      for (const double turn : {1., 2., 5., 10.}) {
        const PlaneErrors errors = ErrorsOnPlane(ratio, turn, n, grid);
        std::string line = fmt::format("| {:g} | {} | {:g} |", ratio, n, turn);
        for (const FootprintErrors& e : errors.pattern) {
          Add(&line, fmt::format("{:.3f}, {:.3f}", e.max, e.rms));
        }
        fmt::print("{} {} |\n", line, kSamples[static_cast<size_t>(errors.chosen)]);
      }
    }
  }
}

RasterErrors OnTriangles(const RasterCase& c, int pattern, int triangles) {
  FootprintSetup::Options options;
  if (pattern < kFootprintPatterns) {
    options.least = options.most = static_cast<FootprintPattern>(pattern);
  }
  return ErrorsOnTriangles(c, options, triangles);
}

void PrintRaster(FootprintForm form, bool perspective, int triangles) {
  fmt::print(
      "\n| axes | n | turn | 1 | 2 | 4 | 8 | own choice | samples |\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const double ratio : {1., 4., 16.}) {
    for (const int n : {8, 32, 128}) {
      for (const double turn : {1., 2.}) {
        std::string line = fmt::format("| {:g} | {} | {:g} |", ratio, n, turn);
        RasterErrors errors;
        for (int pattern = 0; pattern <= kFootprintPatterns; ++pattern) {
          errors = OnTriangles({form, ratio, turn, n, perspective}, pattern, triangles);
          Add(&line, fmt::format("{:.3f}, {:.3f}", errors.errors.max, errors.errors.rms));
        }
        fmt::print("{} {:.2f} |\n", line,
                   static_cast<double>(errors.samples) / static_cast<double>(errors.pixels));
      }
    }
  }
}

void PrintSeams(int trials) {
  fmt::print(
      "\n| spread | moved | diffuse | n = 32 | n = 128 | edge | diffuse | n = 32 | n = 128 |\n"
      "|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
  for (const double spread : {5., 10., 15., 20., 30.}) {
    const SeamErrors errors = SearchSeams(spread, trials);
    std::string line = fmt::format("| {:g} |", spread);
    for (const double angle : {errors.moved, errors.edge}) {
      Add(&line, fmt::format("{:.3f}", angle));
      for (const int n : {1, 32, 128}) Add(&line, Digits(LightChange(angle, n)));
    }
    fmt::print("{}\n", line);
  }
}

}  // namespace
}  // namespace shading::accuracy

int main(int argc, char** argv) {
  using namespace shading;
  using namespace shading::accuracy;
  const bool quick = argc > 1 && std::string_view(argv[1]) == "--quick";
  fmt::print("Highlight on a turning plane: max, RMS, codes\n\n");
  PrintPlane(quick ? 11 : 41);
  fmt::print("\nRasterised triangles of 12 pixels: max, RMS, codes\n");
  for (const bool perspective : {false, true}) {
    fmt::print("\n{}\n", perspective ? "perspective" : "orthographic");
    PrintRaster(FootprintForm::kSeamless, perspective, quick ? 2 : 20);
  }
  fmt::print("\nThe paper's form\n");
  PrintRaster(FootprintForm::kPaper, false, quick ? 2 : 20);
  fmt::print("\nThe paper's form: normals, degrees, and what that does to the light, codes\n");
  PrintSeams(quick ? 1000 : 100000);
  return 0;
}
