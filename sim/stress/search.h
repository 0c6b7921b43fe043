// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "sim/stress/check.h"

namespace shading::stress {

struct Worst {
  double error = -1;
  Genes genes;
  int64_t evaluations = 0;
};

// Directed points, corners of the unit cube, random points, and climbs from the worst so far with
// steps of every octave. The same seed finds the same case.
Worst Search(const Check& check, int64_t evaluations, uint32_t seed, int narrow = 0);

}  // namespace shading::stress
