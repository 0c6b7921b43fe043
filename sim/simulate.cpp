// SPDX-License-Identifier: Apache-2.0
#include "sim/simulate.h"

#include <fmt/format.h>

#include <stdexcept>

#include "model/raster/front_end.h"
#include "sim/io/packet_file.h"
#include "sim/scene/builtin.h"
#include "sim/scene/import.h"
#include "sim/stopwatch.h"

namespace shading::sim {
namespace {

bool EndsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

Frame LoadFrame(const std::string& scene, const Options& options) {
  if (EndsWith(scene, ".jsonl")) {
    if (options.view_given) {
      throw std::runtime_error(
          fmt::format("{}: packets have their own size, camera and light; leave out the options "
                      "that set them",
                      scene));
    }
    return {scene, ReadPackets(scene)};
  }
  const bool builtin = scene.rfind("builtin:", 0) == 0;
  return {scene, Project(builtin ? MakeBuiltin(scene) : ImportMesh(scene), options.view)};
}

std::vector<Frame> LoadFrames(const Options& options) {
  std::vector<Frame> frames;
  for (const std::string& scene : options.scenes) frames.push_back(LoadFrame(scene, options));
  if (!options.triangles_out.empty()) WritePackets(options.triangles_out, frames[0].list);
  return frames;
}

void Describe(const Frame& frame, const FrameWork& work, int lanes, const char* engine,
              RunStats* stats) {
  stats->scene = frame.scene;
  stats->method = Name(work.method);
  stats->engine = engine;
  stats->lanes = lanes;
  stats->width = frame.list.frame.width;
  stats->height = frame.list.frame.height;
  stats->AddWork(work, static_cast<int64_t>(frame.list.triangles.size()));
}

RunStats RunModel(const FrameWork& work, const Options& options, tb::PixelConsumer* consumer) {
  const Stopwatch watch;
  ShadingUnit model(work, options.lanes, FlowPattern::Always(), options.Sink(),
                    options.fraction_bits);
  std::vector<Pixel> pixels(kMaxScreen);
  std::vector<TimedPixel> timed(kMaxScreen);
  RunStats stats;
  stats.cycles = 1;  // an empty frame
  const auto shade = [&](const SpanCommand& span) {
    const SpanTiming timing = model.Span(span, pixels.data());
    for (int i = 0; i < span.length; ++i) {
      timed[static_cast<size_t>(i)] = {pixels[static_cast<size_t>(i)], model.CycleOf(timing, i)};
    }
    consumer->Consume(timed.data(), static_cast<size_t>(span.length));
    stats.cycles = timing.last_left + 1;
    return true;
  };
  ForEachSpan(
      work, [&](size_t t) { model.Triangle(work.triangles[t]); }, shade);
  stats.counters = model.counters();
  stats.sim_seconds = watch.Seconds();
  return stats;
}

RunStats RunRtl(const FrameWork& work, int lanes, const FlowPattern& sink, const std::string& trace,
                tb::PixelConsumer* consumer) {
  const Stopwatch watch;
  tb::Observation observation;
  observation.trace = trace;
  const tb::RtlResult result = tb::RtlShadingUnit::Create(work.method, lanes)
                                   ->Run(work, FlowPattern::Always(), sink, consumer, observation);
  if (!result.finished || result.pixels != work.pixels) {
    throw std::runtime_error(
        fmt::format("RTL: {} of {} pixels; {}", result.pixels, work.pixels,
                    result.failure.empty() ? "run shadesim verify" : result.failure));
  }
  RunStats stats;
  stats.cycles = result.cycles;
  stats.counters = result.counters;
  stats.sim_seconds = watch.Seconds();
  return stats;
}

Checked RunChecked(const FrameWork& work, int lanes, const FlowPattern& source,
                   const FlowPattern& sink, const std::string& trace, bool record_spans) {
  const Stopwatch watch;
  Checked checked;
  tb::Scoreboard scoreboard(work, lanes, source, sink);
  if (record_spans) scoreboard.RecordSpans(&checked.spans);
  tb::Observation observation;
  observation.trace = trace;
  const tb::RtlResult result = tb::RtlShadingUnit::Create(work.method, lanes)
                                   ->Run(work, source, sink, &scoreboard, observation);
  checked.verdicts = scoreboard.Finish(result);
  checked.stats.cycles = result.cycles;
  checked.stats.counters = result.counters;
  checked.stats.sim_seconds = watch.Seconds();
  checked.stats.comparison.emplace().Add(checked.verdicts);
  return checked;
}

}  // namespace shading::sim
