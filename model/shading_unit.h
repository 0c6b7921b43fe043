// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "model/choice/method_choice.h"
#include "model/footprint/footprint_light.h"
#include "model/frame_work.h"
#include "model/light/pixel_light.h"
#include "model/raster/span_setup.h"
#include "model/shading_clock.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Performance counters of one frame: twin of counters_t in shading_pkg.sv.
struct Counters {
  int64_t pixels = 0;        // pixels that left
  int64_t stall = 0;         // cycles: pixels were on offer and not taken
  int64_t setup = 0;         // cycles: no pixel on offer although a span was inside
  int64_t unlit = 0;         // pixels with N.L <= 0; methods that light every pixel
  int64_t no_highlight = 0;  // pixels whose power was not computed; the same
  int64_t normalised = 0;    // normalisations of spans; adaptive methods
  int64_t skipped = 0;       // pixels less those, span by span and not below 0; the same
  int64_t ambient = 0;       // triangles that no light reaches; auto, as are the next four
  int64_t constant = 0;      // spans of one colour
  int64_t dark = 0;          // spans that are lit without a highlight
  int64_t unnormalised = 0;  // spans that are lit without a normalisation
  int64_t black = 0;         // spans times channels that are black
  int64_t samples_taken = 0;     // samples that were lit; footprint methods
  int64_t samples_excluded = 0;  // samples outside the enlarged triangle; the same
  int64_t samples_saved = 0;     // of 7 a pixel, those that were not wanted; the same

  friend bool operator==(const Counters& a, const Counters& b) {
    return a.pixels == b.pixels && a.stall == b.stall && a.setup == b.setup && a.unlit == b.unlit &&
           a.no_highlight == b.no_highlight && a.normalised == b.normalised &&
           a.skipped == b.skipped && a.ambient == b.ambient && a.constant == b.constant &&
           a.dark == b.dark && a.unnormalised == b.unnormalised && a.black == b.black &&
           a.samples_taken == b.samples_taken &&
           a.samples_excluded == b.samples_excluded && a.samples_saved == b.samples_saved;
  }
};

// Bit-exact and cycle-exact model of rtl/shading_unit.sv: one frame, of one method or auto.
class ShadingUnit {
 public:
  // Latency: span accepted to first pixel of an idle unit, for quad. Interval: between two pixels.
  static constexpr UnitContract kContract = {
      "shading_unit",
      "top",
      5,
      1,
      "triangle S9.26, span U12.0",
      "pixel codes U8.0, depth U0.24",
      0.42,
      "screens of 4096 x 4096 pixels, against the method's closed form, before rounding"};

  // lanes: pixels per cycle, 1 or 4. `work` gives method, light and materials and must outlive
  // this.
  ShadingUnit(const FrameWork& work, int lanes, FlowPattern source, FlowPattern sink,
              int paper_fraction_bits = Quantity::kFraction)
      : work_(work),
        paper_fraction_bits_(paper_fraction_bits),
        choice_(ChoiceOf(work.method)),
        clock_(work.method, lanes, std::move(source), std::move(sink)),
        light_(work.light),
        sample_light_(work.light) {
    if (IsAdaptive(work.method)) segments_.reserve(kMaxScreen);
  }

  // The triangle must outlive its spans.
  void Triangle(const TriangleState& triangle);

  // Shades one span of the current triangle into `pixels`, which must hold span.length of them.
  SpanTiming Span(const SpanCommand& span, Pixel* pixels);

  // The cycle in which pixel i of the latest span left.
  int64_t CycleOf(const SpanTiming& timing, int i) const {
    const int64_t group = clock_.lanes() == 1 ? i : i / clock_.lanes();
    if (IsAdaptive(work_.method) || IsFootprint(work_.method)) return clock_.LeftOf(group);
    return clock_.sink().always() ? timing.first_valid + group
                                  : clock_.sink().Select(timing.sink_rank + group);
  }

  const SpanSeed& seed() const { return seed_; }  // of the latest span
  const Counters& counters() const { return counters_; }

 private:
  int Divide(const SpanCommand& span);
  void CountSkips();  // of a span in an auto frame
  template <int kLanes>
  void LightPixels(const SpanCommand& span, Pixel* pixels);
  template <int kLanes, typename Shader>
  void LightSpan(Shader shader, Pixel* pixels);
  template <int kLanes>
  void LightFootprints(const SpanCommand& span, Pixel* pixels);

  const FrameWork& work_;
  int paper_fraction_bits_;
  Choice choice_;  // of the current triangle
  ShadingClock clock_;
  PixelLight light_;
  FootprintLight sample_light_;
  const TriangleState* triangle_ = nullptr;
  int row_ = 0;  // of the latest span
  std::vector<AdaptiveSegment> segments_;  // likewise
  SpanSeed seed_;
  Counters counters_;
};

}  // namespace shading
