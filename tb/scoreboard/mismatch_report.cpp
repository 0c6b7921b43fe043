// SPDX-License-Identifier: Apache-2.0
#include "tb/scoreboard/mismatch_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>

namespace shading::tb {
namespace {

constexpr int64_t kWindow = 64;  // cycles before and after the first difference
constexpr const char* kChannelName[kChannels] = {"red", "green", "blue"};

// Ends the simulation some time after the window, also when the RTL never would.
class UntilCycle : public PixelConsumer {
 public:
  explicit UntilCycle(int64_t last) : last_(last) {}
  bool Consume(const TimedPixel* pixels, size_t count) override {
    return pixels[count - 1].cycle <= last_;
  }

 private:
  int64_t last_;
};

std::string Field(const char* name, int64_t rtl, int64_t model) {
  return rtl == model ? "" : fmt::format("    {}: RTL {}, model {}\n", name, rtl, model);
}

std::string PixelFields(const Mismatch& m) {
  const Pixel& rtl = m.actual.pixel;
  const Pixel& model = m.expected.pixel;
  return Field("x", rtl.x, model.x) + Field("y", rtl.y, model.y) +
         Field("depth, raw U0.24", rtl.z, model.z) + Field("red", rtl.r, model.r) +
         Field("green", rtl.g, model.g) + Field("blue", rtl.b, model.b) +
         Field("last of its span", rtl.last, model.last) +
         Field("cycle", m.actual.cycle, m.expected.cycle);
}

std::string NormalSeedText(const NormalSeed& seed, int lanes) {
  std::string text =
      fmt::format("kappa {} 4^-{}\n", seed.kappa.mantissa.raw(), seed.kappa.exponent);
  for (size_t q = 0; q < seed.quantity.size(); ++q) {
    for (size_t lane = 0; lane < static_cast<size_t>(lanes); ++lane) {
      const QuantitySeed& s = seed.quantity[q][lane];
      text += fmt::format("      quantity {} lane {} first {} difference {}\n", q, lane,
                          s.first.raw(), s.difference.raw());
    }
  }
  return text;
}

std::string CosineSeedText(const SpanSeed& seed) {
  constexpr std::array<const char*, kCurves> kNames = {"N.L", "N.H, N.V", "|N|^2"};
  std::string text = "\n";
  for (size_t i = 0; i < kCurves; ++i) {
    const CurveSeed& c = seed.curve[i];
    text += fmt::format("      {:9} first {} difference {} curvature {}\n",
                        kNames[i], c.first.raw(), c.difference.raw(),
                        c.curvature.raw());
  }
  return text;
}

std::string SeedText(const SpanSeed& seed, Method method, int lanes) {
  if (InterpolatesNormals(method)) return NormalSeedText(seed.normal, lanes);
  if (InterpolatesCosines(method)) return CosineSeedText(seed);
  std::string text = fmt::format("x {} y {} length {} z {} dz/dx {}\n", seed.x, seed.y, seed.length,
                                 seed.z.raw(), seed.dz_dx.raw());
  for (size_t ch = 0; ch < kChannels; ++ch) {
    const ChannelSeed& c = seed.channel[ch];
    text +=
        fmt::format("      {:5} first {} second {} difference {} curvature {}\n", kChannelName[ch],
                    c.first.raw(), c.second.raw(), c.difference.raw(), c.curvature.raw());
  }
  return text;
}

std::string Coefficients(const Mismatch& m) {
  std::string text;
  for (size_t ch = 0; ch < kChannels; ++ch) {
    const Surface& s = m.surface[ch];
    text += fmt::format("      {:5} A {} B {} C {} D {} E {} F {}\n", kChannelName[ch], s.a.raw(),
                        s.b.raw(), s.c.raw(), s.d.raw(), s.e.raw(), s.f.raw());
  }
  return text;
}

std::string FirstDifference(const FrameWork& work, const Verdicts& verdicts) {
  if (verdicts.mismatches.empty()) {
    return fmt::format("  {}compared {} of {} pixels, {} of {} spans; counters {}\n",
                       verdicts.failure.empty() ? "" : verdicts.failure + "; ",
                       verdicts.pixels_compared, verdicts.pixels_expected, verdicts.spans_compared,
                       verdicts.spans_expected, verdicts.counters_match ? "agree" : "differ");
  }
  const Mismatch& m = verdicts.mismatches.front();
  if (m.unexpected) {
    return fmt::format("  a pixel after the last one expected: ({}, {}) in cycle {}\n",
                       m.actual.pixel.x, m.actual.pixel.y, m.actual.cycle);
  }
  return fmt::format("  {} triangle {}, span {}, pixel {} of {} at ({}, {}):\n", Name(work.method),
                     m.triangle, m.span, m.index, m.command.length, m.expected.pixel.x,
                     m.expected.pixel.y) +
         PixelFields(m) +
         (LightsPixels(work.method) ? ""
                                    : "    coefficients S9.26, raw\n" + Coefficients(m));
}

}  // namespace

std::string ReportMismatch(const FrameWork& work, int lanes, const Verdicts& verdicts,
                           const FlowPattern& source, const FlowPattern& sink,
                           const std::string& waveform) {
  std::string text = FirstDifference(work, verdicts);
  Observation observation;
  observation.trace = waveform;
  if (!verdicts.mismatches.empty()) {
    const Mismatch& m = verdicts.mismatches.front();
    const auto [first, last] =
        std::minmax(m.actual.cycle, m.unexpected ? m.actual.cycle : m.expected.cycle);
    observation.first = std::max<int64_t>(first - kWindow - m.index, 0);
    observation.last = last + kWindow;
    observation.probe_span = m.unexpected ? -1 : m.span;
  }
  UntilCycle until(observation.last);
  RtlResult again;
  try {
    again =
        RtlShadingUnit::Create(work.method, lanes)->Run(work, source, sink, &until, observation);
  } catch (const std::exception& error) {
    return text + fmt::format("  no waveform: {}\n", error.what());
  }
  if (again.probe) {
    text += "    seed in the RTL: " + SeedText(*again.probe, work.method, lanes);
    text +=
        "    seed in the model: " + SeedText(verdicts.mismatches.front().seed, work.method, lanes);
  }
  return text + fmt::format("  waveform: {} (gtkwave opens the .gtkw file beside it)\n", waveform);
}

}  // namespace shading::tb
