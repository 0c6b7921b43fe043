// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "model/footprint/footprint_setup.h"
#include "tests/accuracy/footprint_plane.h"

namespace shading::accuracy {

// Rasterised triangles of a surface that is seen at a slant, against the ideal footprint of every
// covered pixel: set-up, spans, recurrences, samples, light, mean. Full-scale highlight.
struct RasterErrors {
  FootprintErrors errors;
  int64_t pixels = 0;
  int64_t samples = 0, excluded = 0;  // taken, and outside
};

struct RasterCase {
  FootprintForm form = FootprintForm::kSeamless;
  double ratio = 1;  // axes of the ellipse on the surface: 1 / cos(slant)
  double turn = 1;   // degrees along the major semi-axis
  int shininess = 32;
  bool perspective = false;
};

// `triangles` of 12 pixels; all with one pattern, or each with its own.
RasterErrors ErrorsOnTriangles(const RasterCase& c, const FootprintSetup::Options& options,
                               int triangles);

}  // namespace shading::accuracy
