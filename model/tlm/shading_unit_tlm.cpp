// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/shading_unit_tlm.h"

#include <vector>

namespace shading {

ShadingDevice::CoreResult ShadingUnitTlm::Shade(const FrameWork& work,
                                                const FlowPattern& pixel_flow, SpanSink* sink) {
  ShadingUnit unit(work, 1, FlowPattern::Always(), pixel_flow);
  std::vector<Pixel> pixels(kMaxScreen);
  auto triangle = work.triangles.begin();
  bool first_span = true;
  int64_t last_left = 0;
  for (const SpanCommand& span : work.spans) {
    if (first_span) unit.Triangle(*triangle++);
    first_span = span.last;
    last_left = unit.Span(span, pixels.data()).last_left;
    if (!sink->Accept(pixels.data(), span.length, last_left)) break;
  }
  return {unit.counters(), last_left + 1, false};
}

}  // namespace shading
