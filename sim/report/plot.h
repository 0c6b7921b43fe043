// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim/report/label_placer.h"
#include "sim/report/scale.h"

namespace shading::report {

struct Axis {
  std::string label;
  bool logarithmic = false;
};

struct Mark {
  double x = 0, y = 0;
  std::string label;    // beside it; may be empty
  std::string hint;     // shown under the pointer
  int colour = 0;       // 0..7 of the page's style
  bool dim = false;     // grey ring
  bool square = false;  // else a circle
};

struct Line {
  std::vector<std::pair<double, double>> points;
  std::string label;        // may be empty
  bool label_left = false;  // at its left end, else beside the right one
  int colour = 0;
  bool dashed = false;  // a front: steps, dashed, neutral
};

// An inline SVG of marks and lines over two axes, in the colours of the page.
class Plot {
 public:
  Plot(std::string title, Axis x, Axis y, int width, int height)
      : title_(std::move(title)),
        x_(std::move(x)),
        y_(std::move(y)),
        width_(width),
        height_(height) {}

  void Add(Mark mark) { marks_.push_back(std::move(mark)); }
  void Add(Line line) { lines_.push_back(std::move(line)); }

  // Values at or below 0 are left out of logarithmic axes.
  std::string Svg() const;

 private:
  struct Drawing {
    Box frame;
    Scale x, y;
    std::string svg;
  };
  bool Drawable(double x, double y) const;
  Drawing Begin() const;
  void DrawAxes(Drawing* drawing) const;
  void DrawLines(Drawing* drawing) const;
  void DrawLineLabels(Drawing* drawing) const;
  void DrawMarks(Drawing* drawing) const;

  std::string title_;
  Axis x_, y_;
  int width_, height_;
  std::vector<Mark> marks_;
  std::vector<Line> lines_;
};

}  // namespace shading::report
