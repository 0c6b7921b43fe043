// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace shading::sim {

std::vector<size_t> ParetoFront(const std::vector<CostError>& points) {
  std::vector<size_t> order;
  for (size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points[i].cost) && std::isfinite(points[i].error)) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                            : points[a].error < points[b].error;
  });
  std::vector<size_t> front;
  double least = std::numeric_limits<double>::infinity();  // error of all cheaper points
  for (const size_t i : order) {
    const bool equal = !front.empty() && points[i].cost == points[front.back()].cost &&
                       points[i].error == points[front.back()].error;
    if (points[i].error < least || equal) front.push_back(i);
    least = std::min(least, points[i].error);
  }
  return front;
}

}  // namespace shading::sim
