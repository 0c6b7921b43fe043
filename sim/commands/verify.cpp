// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "model/raster/front_end.h"
#include "sim/commands/commands.h"
#include "sim/parallel.h"
#include "sim/progress.h"
#include "sim/simulate.h"
#include "tb/scoreboard/mismatch_report.h"
#include "tb/stimulus/random_triangles.h"

namespace shading::sim {
namespace {

constexpr int64_t kTrianglesPerFrame = 500;

// One comparison: a frame by one method.
struct Task {
  Method method = Method::kFlat;
  size_t run = 0;    // which line of the result it adds to
  size_t frame = 0;  // scene, or number of the random frame
};

struct Failure {
  int number = 0;  // of its task
  FrameWork work;
  tb::Verdicts verdicts;
  FlowPattern source;
  std::string scene;
};

class Verifier {
 public:
  explicit Verifier(const Options& options) : options_(options), frames_(LoadFrames(options)) {
    const size_t scenes = random() ? 1 : frames_.size();
    const auto chunks =
        static_cast<size_t>((options.random + kTrianglesPerFrame - 1) / kTrianglesPerFrame);
    for (size_t scene = 0; scene < scenes; ++scene) {
      for (const Method method : options.methods) {
        for (size_t k = 0; k < (random() ? chunks : 1); ++k) {
          tasks_.push_back({method, runs_.size(), random() ? k : scene});
        }
        runs_.emplace_back();
      }
    }
  }

  int Run() {
    {
      Progress progress("verify", static_cast<int64_t>(tasks_.size()), options_.quiet);
      ParallelFor(options_.jobs, static_cast<int>(tasks_.size()), [&](int i) {
        RunTask(i);
        progress.Step();
      });
    }
    const bool good = std::all_of(runs_.begin(), runs_.end(), [](const RunStats& run) {
      return run.comparison->Good() && run.comparison->pixels_compared == run.counters.pixels;
    });
    const auto empty = std::find_if(runs_.begin(), runs_.end(), [](const RunStats& run) {
      return run.comparison->pixels_compared == 0;
    });
    if (!options_.json.empty()) WriteJson(options_.json, options_.command_line, runs_);
    if (!options_.quiet) {
      for (const RunStats& run : runs_) fmt::print("{}\n", Summary(run));
      if (!good) {
        fmt::print("FAIL: RTL and model differ\n");
      } else if (empty == runs_.end()) {
        fmt::print("PASS: RTL = model on every pixel and every cycle\n");
      }
    }
    if (empty != runs_.end()) {
      fmt::print(stderr, "shadesim: {} {}: covers no pixel, nothing was compared; {}\n",
                 empty->scene, empty->method, random() ? "raise --random" : "turn or enlarge it");
    }
    if (failed_) fmt::print(stderr, "{}", FirstDifference());
    return good && empty == runs_.end() ? 0 : 1;
  }

 private:
  bool random() const { return options_.random > 0; }

  Frame RandomFrame(size_t k) const {
    const auto done = static_cast<int64_t>(k) * kTrianglesPerFrame;
    const auto count = static_cast<int>(std::min(kTrianglesPerFrame, options_.random - done));
    // Frames of neighbouring seeds have nothing in common: steps of 2^32 / golden ratio.
    const auto seed = options_.seed * 0x9e3779b9u + static_cast<uint32_t>(k);
    return {fmt::format("random, seed {}", options_.seed), tb::RandomTriangles(seed, count)};
  }

  void RunTask(int number) {
    const Task& task = tasks_[static_cast<size_t>(number)];
    const Frame drawn = random() ? RandomFrame(task.frame) : Frame{};
    const Frame& frame = random() ? drawn : frames_[task.frame];
    const FrameWork work = FrontEnd::Run(frame.list, task.method, options_.front_end);
    // Every other random frame also meets gaps in the commands.
    const FlowPattern source = random() && task.frame % 2 == 1
                                   ? FlowPattern::Random(options_.seed + 1)
                                   : FlowPattern::Always();
    const FlowPattern sink = options_.Sink();
    Checked checked = RunChecked(work, options_.lanes, source, sink, options_.trace, false);
    Describe(frame, work, options_.lanes, "rtl", &checked.stats);

    const std::lock_guard<std::mutex> lock(mutex_);
    RunStats& run = runs_[task.run];
    if (run.scene.empty()) {
      run = checked.stats;
      if (random()) run.width = run.height = 0;  // each frame has its own
    } else {
      run.Add(checked.stats);
    }
    if (!checked.verdicts.Good() && (!failed_ || number < failed_->number)) {
      failed_ = Failure{number, work, checked.verdicts, source, frame.scene};
    }
  }

  // The failing task of the lowest number, so that every run of a command reports the same.
  std::string FirstDifference() const {
    const Task& task = tasks_[static_cast<size_t>(failed_->number)];
    const std::string waveform = fmt::format("shadesim-mismatch-{}.fst", Name(task.method));
    return fmt::format("shadesim: first difference in {}{}\n", failed_->scene,
                       random() ? fmt::format(", frame {}", task.frame) : "") +
           tb::ReportMismatch(failed_->work, options_.lanes, failed_->verdicts, failed_->source,
                              options_.Sink(), waveform);
  }

  const Options& options_;
  std::vector<Frame> frames_;
  std::vector<Task> tasks_;
  std::vector<RunStats> runs_;
  std::mutex mutex_;
  std::optional<Failure> failed_;
};

}  // namespace

int Verify(const Options& options) { return Verifier(options).Run(); }

}  // namespace shading::sim
