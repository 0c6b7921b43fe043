// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace shading::report {

struct Box {
  double left, top, right, bottom;
  bool Overlaps(const Box& other) const {
    return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
  }
};

// Finds places for labels beside marks: inside the frame, off all marks and off each other.
class LabelPlacer {
 public:
  explicit LabelPlacer(const Box& frame) : frame_(frame) {}

  void Occupy(const Box& box) { taken_.push_back(box); }

  struct Place {
    double x = 0, y = 0;    // left end of the baseline
    bool found = false;     // false: it covers something
    bool far_away = false;  // deserves a line to its mark
    double line_x = 0, line_y = 0;
  };
  // For a label of a mark at (x, y); the place is then taken.
  Place Find(double x, double y, const std::string& label);

  static double WidthOf(const std::string& label);
  static constexpr double kHeight = 12;

 private:
  bool Free(const Box& box) const;

  Box frame_;
  std::vector<Box> taken_;
};

}  // namespace shading::report
