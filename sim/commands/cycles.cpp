// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <array>

#include "model/raster/front_end.h"
#include "sim/commands/commands.h"
#include "sim/io/atomic_file.h"
#include "sim/parallel.h"
#include "sim/progress.h"
#include "sim/simulate.h"
#include "tb/scoreboard/mismatch_report.h"

namespace shading::sim {
namespace {

struct CyclesRun {
  FrameWork work;
  Checked checked;
};

// Calls visit(span, packet, RTL cycles, model cycles, record). A span's cycles run from the exit of
// the pixel before it to the exit of its own last pixel, so that they add up to the frame's.
template <typename Visit>
void ForEachSpan(const CyclesRun& run, const Visit& visit) {
  int64_t rtl_before = -1, model_before = -1;  // cycle 0 counts
  size_t triangle = 0;
  for (size_t k = 0; k < run.checked.spans.size(); ++k) {
    const tb::SpanRecord& record = run.checked.spans[k];
    const SpanCommand& span = run.work.spans[k];
    visit(span, run.work.packet[triangle], record.rtl_last_left - rtl_before,
          record.model.last_left - model_before, record);
    rtl_before = record.rtl_last_left;
    model_before = record.model.last_left;
    if (span.last) ++triangle;
  }
}

void WriteCsv(const std::string& path, const std::vector<CyclesRun>& runs) {
  AtomicFile file(path);
  file.stream() << "triangle,y,x,length,method,cycles_rtl,cycles_model,setup,stall,"
                   "normalised,skipped\n";
  for (const CyclesRun& run : runs) {
    ForEachSpan(run, [&](const SpanCommand& span, uint32_t packet, int64_t rtl, int64_t model,
                         const tb::SpanRecord& record) {
      fmt::print(file.stream(), "{},{},{},{},{},{},{},{},{},{},{}\n", packet, span.y, span.x,
                 span.length, Name(run.work.method), rtl, model, record.model.setup,
                 record.model.stall, record.normalised, record.skipped);
    });
  }
  file.Commit();
}

// Spans by length: how many, and how many pixels leave in a cycle.
std::string LengthTable(const CyclesRun& run) {
  struct Bin {
    int from = 0;
    const char* name = "";
    int64_t spans = 0, pixels = 0, cycles = 0, setup = 0, stall = 0;
  };
  std::array<Bin, 7> bins = {{{1, "1"},
                              {2, "2-3"},
                              {4, "4-7"},
                              {8, "8-15"},
                              {16, "16-63"},
                              {64, "64-255"},
                              {256, "256+"}}};
  ForEachSpan(run, [&](const SpanCommand& span, uint32_t, int64_t rtl, int64_t,
                       const tb::SpanRecord& record) {
    size_t at = bins.size() - 1;
    while (bins[at].from > span.length) --at;
    Bin& bin = bins[at];
    ++bin.spans;
    bin.pixels += span.length;
    bin.cycles += rtl;
    bin.setup += record.model.setup;
    bin.stall += record.model.stall;
  });
  std::string text =
      fmt::format("  {:>8} {:>9} {:>10} {:>10} {:>12} {:>12} {:>14}\n", "length", "spans", "pixels",
                  "cycles", "set-up/span", "stall/span", "pixels/cycle");
  for (const Bin& bin : bins) {
    if (bin.spans == 0) continue;
    const auto per_span = [&](int64_t n) {
      return static_cast<double>(n) / static_cast<double>(bin.spans);
    };
    text += fmt::format("  {:>8} {:>9} {:>10} {:>10} {:>12.3f} {:>12.3f} {:>14.4f}\n", bin.name,
                        bin.spans, bin.pixels, bin.cycles, per_span(bin.setup), per_span(bin.stall),
                        static_cast<double>(bin.pixels) / static_cast<double>(bin.cycles));
  }
  return text;
}

}  // namespace

int Cycles(const Options& options) {
  const std::vector<Frame> frames = LoadFrames(options);
  const FlowPattern source = FlowPattern::Always(), sink = options.Sink();
  std::vector<CyclesRun> runs(frames.size() * options.methods.size());
  Progress progress("cycles", static_cast<int64_t>(runs.size()), options.quiet);
  ParallelFor(options.jobs, static_cast<int>(runs.size()), [&](int i) {
    const auto at = static_cast<size_t>(i);
    const Frame& frame = frames[at / options.methods.size()];
    CyclesRun& run = runs[at];
    run.work =
        FrontEnd::Run(frame.list, options.methods[at % options.methods.size()], options.front_end);
    run.checked = RunChecked(run.work, options.lanes, source, sink, options.trace, true);
    Describe(frame, run.work, options.lanes, "rtl", &run.checked.stats);
    progress.Step();
  });

  bool good = true;
  std::vector<RunStats> stats;
  for (const CyclesRun& run : runs) {
    stats.push_back(run.checked.stats);
    if (!options.quiet) fmt::print("{}\n{}", Summary(run.checked.stats), LengthTable(run));
    if (good && !run.checked.verdicts.Good()) {
      fmt::print(
          stderr, "shadesim: first difference in {}\n{}", run.checked.stats.scene,
          tb::ReportMismatch(run.work, options.lanes, run.checked.verdicts, source, sink,
                             fmt::format("shadesim-mismatch-{}.fst", Name(run.work.method))));
      good = false;
    }
  }
  if (!options.csv.empty()) WriteCsv(options.csv, runs);
  if (!options.json.empty()) WriteJson(options.json, options.command_line, stats);
  return good && !ReportEmpty(stats) ? 0 : 1;
}

}  // namespace shading::sim
