// SPDX-License-Identifier: Apache-2.0
//
// Simulation speed per core, in pixels per second: RTL alone, RTL checked against the model, model
// alone. The ratios at the end come from one run on one machine; only they are comparable.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <map>
#include <string>

#include "model/raster/front_end.h"
#include "sim/scene/builtin.h"
#include "sim/scene/camera.h"
#include "tb/rtl_shading_unit.h"
#include "tb/scoreboard/scoreboard.h"

namespace shading {
namespace {

// Triangles of some hundred pixels on a 1280 x 960 screen: spans of 16 pixels and more dominate.
const FrameWork& Work(Method method) {
  static std::map<Method, FrameWork> cache;
  auto [at, is_new] = cache.try_emplace(method);
  if (is_new) {
    sim::ViewOptions view;
    view.width = 1280;
    view.height = 960;
    at->second = FrontEnd::Run(sim::Project(sim::MakeBuiltin("torus:24"), view), method);
  }
  return at->second;
}

class Discard : public tb::PixelConsumer {
 public:
  bool Consume(const TimedPixel* pixels, size_t count) override {
    benchmark::DoNotOptimize(pixels[count - 1].cycle);
    return true;
  }
};

void Finish(benchmark::State& state, const FrameWork& work) {
  state.SetItemsProcessed(state.iterations() * work.pixels);
}

void RtlAlone(benchmark::State& state, Method method) {
  const FrameWork& work = Work(method);
  const FlowPattern always = FlowPattern::Always();
  const auto rtl = tb::RtlShadingUnit::Create(method);
  Discard discard;
  for (auto _ : state) rtl->Run(work, always, always, &discard, {});
  Finish(state, work);
}

void RtlChecked(benchmark::State& state, Method method) {
  const FrameWork& work = Work(method);
  const FlowPattern always = FlowPattern::Always();
  const auto rtl = tb::RtlShadingUnit::Create(method);
  for (auto _ : state) {
    tb::Scoreboard scoreboard(work, 1, always, always);
    const tb::RtlResult result = rtl->Run(work, always, always, &scoreboard, {});
    if (!scoreboard.Finish(result).Good()) state.SkipWithError("RTL and model differ");
  }
  Finish(state, work);
}

void ModelAlone(benchmark::State& state, Method method) {
  const FrameWork& work = Work(method);
  std::vector<Pixel> pixels(kMaxScreen);
  for (auto _ : state) {
    ShadingUnit model(work, 1, FlowPattern::Always(), FlowPattern::Always());
    ForEachSpan(
        work, [&](size_t t) { model.Triangle(work.triangles[t]); },
        [&](const SpanCommand& span) {
          benchmark::DoNotOptimize(model.Span(span, pixels.data()).last_left);
          return true;
        });
  }
  Finish(state, work);
}

// Prints the usual table and keeps the rates for the ratios.
class RatioReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto rate = run.counters.find("items_per_second");
      if (rate != run.counters.end()) rates_[run.benchmark_name()] = rate->second;
    }
    ConsoleReporter::ReportRuns(runs);
  }

  void PrintRatios() const {
    for (const Method method : kAllMethods) {
      const double rtl = Rate("rtl_alone", method), checked = Rate("rtl_checked", method);
      const double model = Rate("model_alone", method);
      if (rtl == 0 || checked == 0 || model == 0) continue;
      fmt::print(
          "{:15} checking costs {:+.0f} % of RTL alone; model alone is {:.0f} times the RTL\n",
          Name(method), 100 * (rtl / checked - 1), model / rtl);
    }
  }

 private:
  double Rate(const char* what, Method method) const {
    const auto at = rates_.find(fmt::format("{}/{}", what, Name(method)));
    return at == rates_.end() ? 0 : at->second;
  }

  std::map<std::string, double> rates_;
};

}  // namespace
}  // namespace shading

int main(int argc, char** argv) {
  using shading::Method;
  for (const Method method : shading::kAllMethods) {
    const std::string name(shading::Name(method));
    benchmark::RegisterBenchmark(("rtl_alone/" + name).c_str(), shading::RtlAlone, method);
    benchmark::RegisterBenchmark(("rtl_checked/" + name).c_str(), shading::RtlChecked, method);
    benchmark::RegisterBenchmark(("model_alone/" + name).c_str(), shading::ModelAlone, method);
  }
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  shading::RatioReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.PrintRatios();
}
