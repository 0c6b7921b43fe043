// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/tlm/shading_device.h"

namespace shading {

// The shading unit with the bit-exact, cycle-exact model as its core.
class ShadingUnitTlm : public ShadingDevice {
 public:
  explicit ShadingUnitTlm(const sc_core::sc_module_name& name, const Options& options = {})
      : ShadingDevice(name, options) {}

 private:
  CoreResult Shade(const FrameWork& work, const FlowPattern& pixel_flow, SpanSink* sink) override;
};

}  // namespace shading
