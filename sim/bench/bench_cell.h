// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/bench/cost_model.h"
#include "sim/picture_error.h"

namespace shading::sim {

// Which measurement: a scene by a method.
struct CellKey {
  std::string scene;
  Method method = Method::kFlat;
  int shininess = 1;     // of all materials
  double tolerance = 0;  // LSB; 0 where the method has none
  int lanes = 1;

  std::string Text() const;
};

// What was measured. Every cycle of a frame is one of: pixels leave, fill, set-up, stall.
struct Cell {
  CellKey key;
  Workload work;
  int64_t packets = 0;
  int64_t cycles = 0;  // of the RTL, always ready
  int64_t busy = 0;    // pixels leave
  int64_t fill = 0;    // before the first pixel, and after the last until the unit is empty
  int64_t setup = 0;   // other cycles without a pixel on offer
  int64_t stall = 0;   // pixels on offer and not taken
  double rtl_seconds = 0, model_seconds = 0, front_end_seconds = 0;  // processor time of one thread
  PictureError phong, closed_form;
  uint32_t sure = 0;  // auto: bit m: method m alone is sure to stay within the tolerance

  double PerPixel(double n) const { return n / static_cast<double>(work.pixels); }
  double PerSpan(double n) const { return n / static_cast<double>(work.spans); }
  double CyclesPerPixel() const { return PerPixel(static_cast<double>(cycles)); }
  Operations OperationsPerPixel() const;
  double PaperCyclesPerPixel() const { return PaperCycles(OperationsPerPixel()); }
  // Triangles to pixels in software: front end and model.
  double SoftwareNanoseconds() const { return PerPixel(1e9 * (front_end_seconds + model_seconds)); }
};

// Steady-state cycles of spans of one length, back to back, always ready.
struct SpanCurve {
  Method method = Method::kFlat;
  int lanes = 1;
  int64_t latency = 0;  // from a span taken to its first pixel on offer, in an idle unit
  struct Point {
    int length = 0;
    double cycles = 0;
  };
  std::vector<Point> points;

  double CyclesOf(int length) const;  // of the nearest length measured
};

// Methods that trade accuracy for work by --tolerance.
bool UsesTolerance(Method method);

// The method of a name in a file; throws std::invalid_argument.
Method MethodOf(const std::string& name);

}  // namespace shading::sim
