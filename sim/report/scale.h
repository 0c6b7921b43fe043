// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace shading::report {

// From values to places on the screen along one axis, linear or logarithmic.
class Scale {
 public:
  // The range is widened by a margin and where it is empty; logarithmic ranges must be above 0.
  Scale(double low, double high, bool logarithmic, double from, double to);

  double operator()(double value) const;
  bool logarithmic() const { return logarithmic_; }

  // Round values inside the range: at most about `most` of them.
  std::vector<double> Ticks(int most) const;

 private:
  std::vector<double> LogTicks(int most) const;
  std::vector<double> LinearTicks(int most) const;

  bool logarithmic_;
  double low_, high_, from_, to_;
};

}  // namespace shading::report
