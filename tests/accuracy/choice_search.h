// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <random>

#include "tests/accuracy/choice_error.h"

namespace shading::accuracy {

// What the search moves: a triangle of normals by its sides, light, viewer, shininess and point.
struct ChoicePoint {
  double chord = 0.1;          // the longest |Ni - Nj|
  double near = 1, apart = 1;  // 0..1: the other two sides
  double shininess = 1;
  ideal::Vector light, half_or_view;
  std::array<std::array<double, 3>, 2> end;
  double along = 0;
  bool edge = false;  // the point is on an edge of the triangle

  ChoiceCase Case() const;
};

// Where the search may go.
struct ChoiceRegion {
  double least_chord = 0.01, most_chord = 1;
  double least_shininess = 1, most_shininess = 256;
  bool edge = false;
  double highlight = 0;  // starts have it near 2^-highlight at its brightest
  bool reflected = false;
};

// Hill-climbing from random starts for the most of an objective; points outside are worth less than
// 0. The same seed finds the same.
class ChoiceSearch {
 public:
  using Objective = std::function<double(const ChoicePoint&)>;
  struct Found {
    double value = -1;
    ChoicePoint point;
  };

  explicit ChoiceSearch(unsigned seed) : random_(seed) {}
  Found Run(const ChoiceRegion& region, const Objective& objective, int restarts, int steps);
  ChoicePoint Start(const ChoiceRegion& region);
  ChoicePoint Neighbor(ChoicePoint point, const ChoiceRegion& region, double scale);

 private:
  double Gauss() { return gauss_(random_); }
  double Uniform() { return uniform_(random_); }
  double Between(double least, double most);
  ideal::Vector Aside(const ideal::Vector& v, double angle);
  std::array<double, 3> RandomWeight(bool edge);
  void MoveWeight(std::array<double, 3>* weight, double scale, bool edge);

  std::mt19937 random_;
  std::normal_distribution<double> gauss_;
  std::uniform_real_distribution<double> uniform_;
};

}  // namespace shading::accuracy
