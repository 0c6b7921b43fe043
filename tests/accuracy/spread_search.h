// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "tests/accuracy/spread_error.h"

namespace shading::accuracy {

struct SpreadEffort {
  int restarts, starts, steps;  // each restart climbs from the best of its starts
};
inline constexpr SpreadEffort kFullSearch = {600, 20, 500};
inline constexpr SpreadEffort kQuickSearch = {80, 20, 400};

struct SpreadWorst {
  double error = -1;  // codes, before they are rounded
  SpreadCase at;
};

// The largest error of a method over triangles whose normals are at most `degrees` apart, and one
// pair just so far: over the shape of the triangle, the directions of L and H and the point, by
// random restarts, hill-climbing, and a last, longer climb from the best. The same seed finds the
// same.
class SpreadSearch {
 public:
  SpreadSearch(Method method, const SpreadLight& light, double degrees);
  SpreadWorst Run(const SpreadEffort& effort, unsigned seed = 1);

 private:
  // Normals 0 and 1 are `spread_` apart. Normal 2 is `near` of that from 0, and from 1 as far as
  // `apart` says, between the least and the most that there can be.
  struct Point {
    double near = 1, apart = 1;    // 0..1
    ideal::Vector light, half;     // unit
    std::array<double, 3> weight;  // sum 1
  };
  struct Found {
    double error = -1;
    Point point;
  };

  double Gauss() { return gauss_(random_); }
  double Uniform() { return uniform_(random_); }
  std::array<ideal::Vector, 3> NormalsOf(const Point& point) const;
  ideal::Vector Aside(const ideal::Vector& v, double angle);
  std::array<double, 3> RandomWeight();
  Point Start(int restart);
  Point Neighbor(Point point, double scale);
  Found Evaluate(const Point& point) const;
  Found Climb(Found best, int steps);
  SpreadCase CaseOf(const Point& point) const;

  Method method_;
  SpreadLight light_;
  double spread_, width_;  // radians; from the highlight's peak to its steepest slope
  std::mt19937 random_;
  std::normal_distribution<double> gauss_;
  std::uniform_real_distribution<double> uniform_;
};

// The error searched for at one spread.
double SearchedError(Method method, const SpreadLight& light, double degrees,
                     const SpreadEffort& effort);

// The spread at which it reaches `codes`, within 0.1 % of them; at most 120 degrees.
double SearchedLimit(Method method, const SpreadLight& light, double codes,
                     const SpreadEffort& effort);

}  // namespace shading::accuracy
