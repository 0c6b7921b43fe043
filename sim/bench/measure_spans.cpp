// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "model/normal/adaptive_normalizer.h"
#include "sim/bench/measure.h"
#include "tb/rtl_shading_unit.h"

namespace shading::sim {
namespace {

// What the adaptive methods depend on; see MeasureSpans.
constexpr double kTurn = 10;  // degrees between the normals at the ends of a span
constexpr double kTolerance = 0.5;
constexpr int kShininess = 32;

// Spans of one length on rows below each other, of one triangle.
FrameWork Rows(Method method, int length, int spans) {
  FrameWork work;
  work.method = method;
  work.triangles.emplace_back();
  work.triangles[0].limit = AdaptiveNormalizer::LimitOf(
      Tolerance::Round(kTolerance), Shininess::FromRaw(int64_t{kShininess} << Shininess::kFraction),
      true, Lighting::kBlinn);
  work.packet.push_back(0);
  if (LightsPixels(method)) work.materials.emplace_back();
  const double turn = kTurn * std::acos(-1.0) / 180;
  for (int y = 0; y < spans; ++y) {
    SpanCommand span;
    span.y = y;
    span.length = length;
    span.last = y == spans - 1;
    span.normal[0][2] = SpanNormalComponent::Round(1);
    span.normal[1][0] = SpanNormalComponent::Round(std::sin(turn));
    span.normal[1][2] = SpanNormalComponent::Round(std::cos(turn));
    work.spans.push_back(span);
  }
  work.pixels = int64_t{length} * spans;
  return work;
}

class LastPixels : public tb::PixelConsumer {
 public:
  bool Consume(const TimedPixel* pixels, size_t count) override {
    for (size_t i = 0; i < count; ++i) {
      if (pixels[i].pixel.last != 0) cycles_.push_back(pixels[i].cycle);
    }
    return true;
  }
  const std::vector<int64_t>& cycles() const { return cycles_; }

 private:
  std::vector<int64_t> cycles_;
};

}  // namespace

SpanCurve MeasureSpans(Method method, int lanes, const std::vector<int>& lengths, int spans) {
  SpanCurve curve;
  curve.method = method;
  curve.lanes = lanes;
  const FlowPattern always = FlowPattern::Always();
  const auto rtl = tb::RtlShadingUnit::Create(method, lanes);
  {
    LastPixels last;
    // The cycle in which the span is taken, and those in which nothing is on offer.
    curve.latency = 1 + rtl->Run(Rows(method, 1, 1), always, always, &last, {}).counters.setup;
  }
  for (const int length : lengths) {
    LastPixels last;
    const tb::RtlResult result = rtl->Run(Rows(method, length, spans), always, always, &last, {});
    const auto count = static_cast<size_t>(spans);
    if (!result.finished || last.cycles().size() != count) {
      throw std::runtime_error(fmt::format(
          "{}: the RTL lost spans of {} pixels; run shadesim verify", Name(method), length));
    }
    const size_t half = count / 2;
    const auto taken = last.cycles()[count - 1] - last.cycles()[count - 1 - half];
    curve.points.push_back({length, static_cast<double>(taken) / static_cast<double>(half)});
  }
  return curve;
}

}  // namespace shading::sim
