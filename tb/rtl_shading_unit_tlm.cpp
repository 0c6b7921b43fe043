// SPDX-License-Identifier: Apache-2.0
#include "tb/rtl_shading_unit_tlm.h"

#include <vector>

namespace shading::tb {
namespace {

// Cuts the stream of pixels into spans.
class SpanCutter : public PixelConsumer {
 public:
  explicit SpanCutter(SpanSink* sink) : sink_(*sink) { pixels_.reserve(kMaxScreen); }

  bool Consume(const TimedPixel* pixels, size_t count) override {
    for (size_t i = 0; i < count; ++i) {
      pixels_.push_back(pixels[i].pixel);
      if (!pixels[i].pixel.last) continue;
      const auto length = static_cast<int>(pixels_.size());
      if (!sink_.Accept(pixels_.data(), length, pixels[i].cycle)) return false;
      pixels_.clear();
    }
    return pixels_.size() < kMaxScreen;
  }

 private:
  SpanSink& sink_;
  std::vector<Pixel> pixels_;
};

}  // namespace

RtlShadingUnitTlm::RtlShadingUnitTlm(const sc_core::sc_module_name& name, const Options& options)
    : ShadingDevice(name, options), rtl_(RtlShadingUnit::CreateAll()) {}

ShadingDevice::CoreResult RtlShadingUnitTlm::Shade(const FrameWork& work,
                                                   const FlowPattern& pixel_flow, SpanSink* sink) {
  SpanCutter cutter(sink);
  const RtlResult result = rtl_->Run(work, FlowPattern::Always(), pixel_flow, &cutter, {});
  return {result.counters, result.cycles, !result.finished};
}

}  // namespace shading::tb
