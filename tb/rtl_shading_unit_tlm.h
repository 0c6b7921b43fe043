// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "model/tlm/shading_device.h"
#include "tb/rtl_shading_unit.h"

namespace shading::tb {

// The shading unit with the Verilated RTL as its core: the same sockets, pixels, counters and times
// as ShadingUnitTlm.
class RtlShadingUnitTlm : public ShadingDevice {
 public:
  explicit RtlShadingUnitTlm(const sc_core::sc_module_name& name, const Options& options = {});

 private:
  CoreResult Shade(const FrameWork& work, const FlowPattern& pixel_flow, SpanSink* sink) override;

  std::unique_ptr<RtlShadingUnit> rtl_;
};

}  // namespace shading::tb
