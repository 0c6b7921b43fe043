// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/bench_cell.h"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

namespace shading::sim {

std::string CellKey::Text() const {
  return fmt::format("{} {} n={} tolerance={} lanes={}", scene, Name(method), shininess, tolerance,
                     lanes);
}

Operations Cell::OperationsPerPixel() const {
  return (1.0 / static_cast<double>(work.pixels)) * TotalOf(key.method, work);
}

double SpanCurve::CyclesOf(int length) const {
  double cycles = 0;
  int best = INT32_MAX;
  for (const Point& point : points) {
    const int distance = std::abs(point.length - length);
    if (distance >= best) continue;
    best = distance;
    cycles = point.cycles;
  }
  return cycles;
}

bool UsesTolerance(Method method) {
  return method == Method::kQuadSegment || IsAdaptive(method) || method == Method::kAuto;
}

Method MethodOf(const std::string& name) {
  for (const Method method : kAllMethods) {
    if (name == Name(method)) return method;
  }
  throw std::invalid_argument("unknown method " + name);
}

}  // namespace shading::sim
