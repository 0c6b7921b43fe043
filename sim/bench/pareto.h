// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace shading::sim {

struct CostError {
  double cost = 0, error = 0;
};

// Indices of the points that no other point dominates, by rising cost. A point dominates another
// that is no better in either and worse in one, so of equal points all stay. Points with a cost or
// an error that is not finite are never on the front.
std::vector<size_t> ParetoFront(const std::vector<CostError>& points);

}  // namespace shading::sim
