// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>

#include "model/raster/front_end.h"
#include "sim/commands/commands.h"
#include "sim/parallel.h"
#include "sim/progress.h"
#include "sim/simulate.h"
#include "sim/stopwatch.h"

namespace shading::sim {
namespace {

constexpr const char* kEngineName[] = {"model", "rtl", "ideal"};

RunStats Simulate(const FrameWork& work, const Options& options, FrameBuffer* picture) {
  PictureConsumer consumer(work, picture);
  if (options.engine == Engine::kRtl) {
    return RunRtl(work, options.lanes, options.Sink(), options.trace, &consumer);
  }
  return RunModel(work, options, &consumer);
}

RunStats RenderOne(const Frame& frame, Method method, const Options& options,
                   const std::string& path) {
  const FrameWork work = FrontEnd::Run(frame.list, method, options.front_end);
  FrameBuffer picture(frame.list.frame.width, frame.list.frame.height);
  RunStats stats = Simulate(work, options, &picture);
  // The ideal engine takes coverage and depth from the model, whose edges are exact.
  if (options.engine == Engine::kIdeal) {
    const Stopwatch watch;
    ShadeIdeally(frame.list, method, &picture);
    stats.sim_seconds = watch.Seconds();
  }
  Describe(frame, work, options.lanes, kEngineName[static_cast<int>(options.engine)], &stats);
  stats.phong_error = ErrorAgainstPhong(picture, frame.list);
  stats.closed_form_error = ErrorAgainstClosedForm(picture, frame.list, method);
  WriteImage(path, picture.ToImage());
  if (!options.error_map.empty()) WriteImage(options.error_map, ErrorMap(picture, frame.list));
  return stats;
}

// image.png, or image-SCENE-METHOD.png with as much of it as tells the pictures apart.
std::string PictureName(const Options& options, size_t scene, Method method) {
  namespace fs = std::filesystem;
  const fs::path path(options.image);
  std::string stem = path.stem().string();
  if (options.scenes.size() > 1) {
    std::string name = fs::path(options.scenes[scene]).stem().string();
    for (char& c : name) c = c == ':' || c == '/' ? '-' : c;
    stem += fmt::format("-{}-{}", scene + 1, name);
  }
  if (!options.OneMethod()) stem += fmt::format("-{}", Name(method));
  return (path.parent_path() / (stem + path.extension().string())).string();
}

// What was written beside the pictures.
void PrintFiles(const Options& options) {
  const auto print = [](const char* what, const std::string& file) {
    if (!file.empty()) fmt::print("  {}: {}\n", what, file);
  };
  print("error map", options.error_map);
  print("numbers", options.json);
  print("triangles", options.triangles_out);
  print("waveform", options.trace);
  if (options.trace.empty()) return;
  print("view of it", std::filesystem::path(options.trace).replace_extension(".gtkw").string());
}

}  // namespace

int Render(const Options& options) {
  CheckImageExtension(options.image);
  if (!options.error_map.empty()) CheckImageExtension(options.error_map);
  const std::vector<Frame> frames = LoadFrames(options);
  const size_t methods = options.methods.size();
  std::vector<RunStats> runs(frames.size() * methods);
  std::vector<std::string> pictures(runs.size());
  {
    Progress progress("render", static_cast<int64_t>(runs.size()), options.quiet);
    ParallelFor(options.jobs, static_cast<int>(runs.size()), [&](int i) {
      const auto at = static_cast<size_t>(i);
      const Method method = options.methods[at % methods];
      pictures[at] = PictureName(options, at / methods, method);
      runs[at] = RenderOne(frames[at / methods], method, options, pictures[at]);
      progress.Step();
    });
  }
  if (!options.json.empty()) WriteJson(options.json, options.command_line, runs);
  const int status = ReportEmpty(runs) ? 1 : 0;
  if (options.quiet) return status;
  for (size_t i = 0; i < runs.size(); ++i) {
    fmt::print("{}\n  picture: {}\n", Summary(runs[i]), pictures[i]);
  }
  PrintFiles(options);
  return status;
}

}  // namespace shading::sim
