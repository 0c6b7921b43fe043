// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/shading_unit_tlm.h"

#include <vector>

namespace shading {

ShadingDevice::CoreResult ShadingUnitTlm::Shade(const FrameWork& work,
                                                const FlowPattern& pixel_flow, SpanSink* sink) {
  ShadingUnit unit(work, 1, FlowPattern::Always(), pixel_flow);
  std::vector<Pixel> pixels(kMaxScreen);
  int64_t last_left = 0;
  ForEachSpan(
      work, [&](size_t t) { unit.Triangle(work.triangles[t]); },
      [&](const SpanCommand& span) {
        last_left = unit.Span(span, pixels.data()).last_left;
        return sink->Accept(pixels.data(), span.length, last_left);
      });
  return {unit.counters(), last_left + 1, false};
}

}  // namespace shading
