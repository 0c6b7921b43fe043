// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/raster/span_setup.h"
#include "model/shading_clock.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Performance counters of one frame, in cycles: twin of counters_t in shading_pkg.sv.
struct Counters {
  int64_t pixels = 0;  // a pixel left
  int64_t stall = 0;   // a pixel was on offer and not taken
  int64_t setup = 0;   // no pixel was on offer although a span was inside

  friend bool operator==(const Counters& a, const Counters& b) {
    return a.pixels == b.pixels && a.stall == b.stall && a.setup == b.setup;
  }
};

// Bit-exact and cycle-exact model of rtl/shading_unit.sv: one frame of one method.
class ShadingUnit {
 public:
  // Latency: span accepted to first pixel of an idle unit, for quad. Interval: between two pixels.
  static constexpr UnitContract kContract = {
      "shading_unit",
      "top",
      8,
      1,
      "triangle S9.26, span U12.0",
      "pixel codes U8.0, depth U0.24",
      0.42,
      "screens of 4096 x 4096 pixels, against the method's closed form, before rounding"};

  ShadingUnit(Method method, FlowPattern source, FlowPattern sink)
      : method_(method), clock_(method, std::move(source), std::move(sink)) {}

  // The triangle must outlive its spans.
  void Triangle(const TriangleState& triangle) {
    triangle_ = &triangle;
    clock_.Triangle();
  }

  // Shades one span of the current triangle into `pixels`, which must hold span.length of them.
  SpanTiming Span(const SpanCommand& span, Pixel* pixels);

  // The cycle in which pixel i of a span left.
  int64_t CycleOf(const SpanTiming& timing, int i) const {
    return clock_.sink().always() ? timing.first_valid + i
                                  : clock_.sink().Select(timing.sink_rank + i);
  }

  const SpanSeed& seed() const { return seed_; }  // of the latest span
  const Counters& counters() const { return counters_; }

 private:
  Method method_;
  ShadingClock clock_;
  const TriangleState* triangle_ = nullptr;
  SpanSeed seed_;
  Counters counters_;
};

}  // namespace shading
