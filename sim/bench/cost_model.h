// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "model/frame_work.h"
#include "model/shading_types.h"

namespace shading::sim {

// What a processor with one adder does. Comparisons, clamps and moves are free, as in paper 003,
// and so are shifts that only align formats, and rounding.
struct Operations {
  double multiplications = 0;
  double additions = 0;  // and subtractions
  double shifts = 0;     // by any number of bits
  double look_ups = 0;   // of a table

  double total() const { return multiplications + additions + shifts + look_ups; }
  friend Operations operator+(const Operations& a, const Operations& b) {
    return {a.multiplications + b.multiplications, a.additions + b.additions, a.shifts + b.shifts,
            a.look_ups + b.look_ups};
  }
  friend Operations operator*(double n, const Operations& o) {
    return {n * o.multiplications, n * o.additions, n * o.shifts, n * o.look_ups};
  }
};

// Paper 003: a product takes 8 cycles, an addition, a subtraction and a shift 1. A look-up, which
// the paper does not have, 1.
constexpr double PaperCycles(const Operations& o) {
  return 8 * o.multiplications + o.additions + o.shifts + o.look_ups;
}

// Operations of a method, part by part.
struct MethodCost {
  Operations triangle;       // light of its nodes and coefficients
  Operations span;           // its start
  Operations pixel;          // every pixel
  Operations highlight;      // more, where the highlight's power is computed
  Operations normalisation;  // more, each; adaptive methods
  Operations sample;         // more, each; footprint methods
  std::string reason;
};

// Counted in the bit-exact models: one place for all methods. Triangle set-up, the walk of the
// edges and depth are the same for all and not in it.
MethodCost CostOf(Method method);

// Of these, what lights a pixel that has a vector: two dot products and the colours.
Operations VectorLight();

// How often each part was done in one frame.
struct Workload {
  int64_t triangles = 0, spans = 0, pixels = 0, highlights = 0, normalisations = 0, samples = 0;
  std::array<MethodShare, kMethodCount> share = {};  // auto: by the method chosen
};
Operations TotalOf(const MethodCost& cost, const Workload& work);
// Of auto: the choice of each triangle, and what the chosen methods do.
Operations TotalOf(Method method, const Workload& work);

}  // namespace shading::sim
