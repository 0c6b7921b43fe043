// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact and cycle model of rtl/raster/span_binder.sv: a span, and the depth step, the
// material and the limit of its triangle. The unit holds one triangle.
class SpanBinder {
 public:
  static constexpr UnitContract kContract = {"span_binder",
                                             "raster",
                                             0,
                                             1,
                                             "triangles and their spans",
                                             "runs with a material",
                                             0,
                                             "spans in the order of their triangles"};

  // The normals of the span and the limit of the triangle pass unchanged beside the run.
  static void Bind(const TriangleState& triangle, const SpanCommand& span, SpanSeed* run) {
    run->x = span.x;
    run->y = span.y;
    run->length = span.length;
    run->z = span.z;
    run->dz_dx = triangle.dz_dx;
    run->material = triangle.material;
  }
  static SpanSeed Bind(const TriangleState& triangle, const SpanCommand& span) {
    SpanSeed run;
    Bind(triangle, span, &run);
    return run;
  }

  // The cycle in which a triangle is taken that is on offer from `offered` on: the one in which the
  // last span of the triangle before passes, at the earliest.
  int64_t TakeTriangle(int64_t offered) {
    triangle_taken_ = std::max(offered, released_);
    return triangle_taken_;
  }
  // The first cycle in which the run of a span is on offer that is itself from `offered` on.
  int64_t OfferRun(int64_t offered) const { return std::max(offered, triangle_taken_); }
  int64_t triangle_taken() const { return triangle_taken_; }  // of the current triangle

  // The run is taken, and with it the span.
  void PassSpan(int64_t cycle, bool last) {
    if (last) released_ = cycle;
  }

 private:
  int64_t triangle_taken_ = 0;
  int64_t released_ = 0;
};

}  // namespace shading
