// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/triangle_packet.h"

namespace shading::ideal {

// Weights of the vertices at a point of the screen, as ratios of signed areas. At pixel centres
// both areas are exact in double (46 bits), so each weight is off by one rounding, however thin
// the triangle. The triangle must have an area; outside it weights are negative.
class Barycentric {
 public:
  using Weights = std::array<double, 3>;

  explicit Barycentric(const TrianglePacket& triangle) {
    for (size_t i = 0; i < 3; ++i) {
      x_[i] = triangle.x[i].ToReal();
      y_[i] = triangle.y[i].ToReal();
    }
    doubled_area_ = DoubledArea(1, 2, x_[0], y_[0]);
  }

  Weights At(double x, double y) const {
    return {DoubledArea(1, 2, x, y) / doubled_area_, DoubledArea(2, 0, x, y) / doubled_area_,
            DoubledArea(0, 1, x, y) / doubled_area_};
  }
  Weights AtPixel(int i, int j) const { return At(i + 0.5, j + 0.5); }

 private:
  double DoubledArea(size_t a, size_t b, double x, double y) const {
    return (x_[a] - x) * (y_[b] - y) - (x_[b] - x) * (y_[a] - y);
  }

  std::array<double, 3> x_, y_;  // pixels
  double doubled_area_;
};

}  // namespace shading::ideal
