// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

#include "model/light/blinn_specular.h"
#include "tests/accuracy/ideal_span.h"
#include "tests/accuracy/span_model.h"

namespace shading::accuracy {

inline constexpr std::array<int, 4> kLengths = {16, 64, 256, 2048};  // pixels
inline constexpr std::array<double, 12> kAngles = {0.01, 0.1, 1,   5,   15,  30,
                                                   60,   90,  120, 150, 170, 179};  // degrees
inline constexpr std::array<int, 5> kShininess = {1, 8, 32, 128, 256};  // 1 stands for diffuse

// One cell of a table: which error is looked for.
struct Cell {
  Configuration configuration;
  Ideal ideal = Ideal::kSlerp;
  int length = 0;
  double least_degrees = 0, degrees = 0;  // range of the angle between the end normals
  int shininess = 1;
};
// Angles of a table's row: up to 0.5 % less than its label.
inline constexpr double kLeastPart = 0.995;

struct Effort {
  int restarts, starts, steps;  // each restart climbs from the best of its starts
  constexpr int evaluations() const { return restarts * (starts + steps); }
};

struct Worst {
  double lsb = 0;  // of 255 codes, before the code is rounded; kd = 1 or ks = 1
  int pixel = 0;
  SpanCase span;
};

// Largest error over all pixels of a span, over orientations of the arc and light directions, by
// random restarts and hill-climbing. One evaluation is one span.
class WorstSearch {
 public:
  explicit WorstSearch(const Cell& cell);
  Worst Run(const Effort& effort, unsigned seed = 1);
  Worst Evaluate(const SpanCase& span);

 private:
  // The arc runs in the plane of the frame's first two axes. The light is seen from pixel `place`:
  // `tilt` from its normal, towards the direction of the arc turned by `azimuth` about the normal.
  struct Point {
    std::array<double, 4> frame;  // quaternion
    double angle;                 // 0..1 from the least to the largest, geometric
    double place;                 // 0..1
    double tilt, azimuth;         // radians
  };

  double Normal() { return normal_(random_); }
  double Uniform() { return uniform_(random_); }
  double StartAngle(int restart);
  Point Start(int restart);
  Point Neighbor(Point point, double scale, bool turn_arc);
  SpanCase SpanOf(const Point& point) const;

  Cell cell_;
  BlinnSpecular power_;
  double width_;  // radians from the peak of the power to its steepest slope
  IdealSpan ideal_;
  std::array<SpanNormal, 2> ideal_ends_ = {};
  std::vector<LightCosines> cosines_;
  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

}  // namespace shading::accuracy
