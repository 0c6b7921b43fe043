// SPDX-License-Identifier: Apache-2.0
#include "sim/run_stats.h"

#include <fmt/format.h>

#include <algorithm>

namespace shading::sim {
namespace {

std::string ChoiceText(const RunStats& run) {
  std::string text;
  for (const Method method : kAllMethods) {
    const MethodShare& share = run.share[static_cast<size_t>(method)];
    if (share.triangles == 0) continue;
    text += fmt::format("{}{} {}", text.empty() ? "\n  pixels by " : ", ", Name(method),
                        share.pixels);
  }
  const Counters& c = run.counters;
  return text + fmt::format("\n  {} triangles only ambient; spans: {} of one colour, {} without "
                            "highlight, {} without normalisation; {} black channels",
                            c.ambient, c.constant, c.dark, c.unnormalised, c.black);
}

std::string WorkText(const RunStats& run) {
  std::string text;
  if (run.skipped.total() > 0) {
    text += fmt::format(
        "\n  skipped {} triangles: {} back-facing, {} degenerate, {} off screen, "
        "{} empty",
        run.skipped.total(), run.skipped.back_facing, run.skipped.degenerate,
        run.skipped.off_screen, run.skipped.empty);
  }
  if (run.counters.unlit + run.counters.no_highlight + run.split_spans > 0) {
    text += fmt::format("\n  {} pixels unlit, {} without highlight, {} spans split",
                        run.counters.unlit, run.counters.no_highlight, run.split_spans);
  }
  if (run.method == Name(Method::kAuto)) text += ChoiceText(run);
  if (run.counters.normalised + run.counters.skipped > 0) {
    text += fmt::format("\n  {} normalisations, {} skipped", run.counters.normalised,
                        run.counters.skipped);
  }
  if (run.counters.samples_taken > 0) {
    text += fmt::format("\n  {} samples taken, {} excluded, {} saved", run.counters.samples_taken,
                        run.counters.samples_excluded, run.counters.samples_saved);
  }
  if (run.over_limit > 0) {
    text += fmt::format("\n  {} triangles turn too far for the tolerance{}", run.over_limit,
                        run.pieces > 0 ? fmt::format(", split into {}", run.pieces) : "");
  }
  return text;
}

std::string ComparisonText(const Comparison& comparison) {
  return fmt::format(
      "\n  compared {} of {} pixels: {} mismatches; {} of {} spans: {} cycle mismatches",
      comparison.pixels_compared, comparison.pixels_expected, comparison.pixel_mismatches,
      comparison.spans_compared, comparison.spans_expected, comparison.cycle_mismatches);
}

std::string ErrorText(const char* ideal, const std::optional<PictureError>& error) {
  return error ? fmt::format("\n  against {}: max {:.2f} LSB, RMS {:.2f} LSB, PSNR {:.1f} dB",
                             ideal, error->max_lsb, error->rms_lsb, error->psnr_db)
               : "";
}

void AddSkips(const SkipCounts& other, SkipCounts* sum) {
  sum->back_facing += other.back_facing;
  sum->degenerate += other.degenerate;
  sum->off_screen += other.off_screen;
  sum->empty += other.empty;
}

void AddShares(const std::array<MethodShare, kMethodCount>& other,
               std::array<MethodShare, kMethodCount>* sum) {
  for (size_t m = 0; m < other.size(); ++m) {
    (*sum)[m].triangles += other[m].triangles;
    (*sum)[m].spans += other[m].spans;
    (*sum)[m].pixels += other[m].pixels;
  }
}

void KeepWorst(const std::optional<PictureError>& other, std::optional<PictureError>* error) {
  if (!other) return;
  if (!*error || other->rms_lsb > (*error)->rms_lsb) {
    const double max = *error ? std::max((*error)->max_lsb, other->max_lsb) : other->max_lsb;
    *error = other;
    (*error)->max_lsb = max;
  } else {
    (*error)->max_lsb = std::max((*error)->max_lsb, other->max_lsb);
  }
}

}  // namespace

void Comparison::Add(const tb::Verdicts& v) {
  Comparison one{v.pixels_expected, v.pixels_compared,  v.pixel_mismatches, v.spans_expected,
                 v.spans_compared,  v.cycle_mismatches, v.Good() ? 0 : 1};
  Add(one);
}

void Comparison::Add(const Comparison& other) {
  pixels_expected += other.pixels_expected;
  pixels_compared += other.pixels_compared;
  pixel_mismatches += other.pixel_mismatches;
  spans_expected += other.spans_expected;
  spans_compared += other.spans_compared;
  cycle_mismatches += other.cycle_mismatches;
  bad_frames += other.bad_frames;
}

double RunStats::PixelCycles() const {
  return counters.pixels > 0
             ? static_cast<double>(cycles) / static_cast<double>(counters.pixels)
             : 0;
}

double RunStats::PixelsPerSecond() const {
  return sim_seconds > 0 ? static_cast<double>(counters.pixels) / sim_seconds : 0;
}

void RunStats::AddWork(const FrameWork& work, int64_t packets) {
  triangles += packets;
  spans += static_cast<int64_t>(work.spans.size());
  split_spans += work.split_spans;
  over_limit += work.over_limit;
  pieces += work.pieces;
  AddSkips(work.skipped, &skipped);
  AddShares(work.share, &share);
}

void RunStats::Add(const RunStats& other) {
  triangles += other.triangles;
  spans += other.spans;
  cycles += other.cycles;
  counters.pixels += other.counters.pixels;
  counters.setup += other.counters.setup;
  counters.stall += other.counters.stall;
  counters.unlit += other.counters.unlit;
  counters.no_highlight += other.counters.no_highlight;
  counters.normalised += other.counters.normalised;
  counters.skipped += other.counters.skipped;
  counters.ambient += other.counters.ambient;
  counters.constant += other.counters.constant;
  counters.dark += other.counters.dark;
  counters.unnormalised += other.counters.unnormalised;
  counters.black += other.counters.black;
  counters.samples_taken += other.counters.samples_taken;
  counters.samples_excluded += other.counters.samples_excluded;
  counters.samples_saved += other.counters.samples_saved;
  split_spans += other.split_spans;
  over_limit += other.over_limit;
  pieces += other.pieces;
  AddSkips(other.skipped, &skipped);
  AddShares(other.share, &share);
  sim_seconds += other.sim_seconds;
  if (other.comparison) {
    if (!comparison) comparison.emplace();
    comparison->Add(*other.comparison);
  }
  KeepWorst(other.phong_error, &phong_error);
  KeepWorst(other.closed_form_error, &closed_form_error);
}

std::string Summary(const RunStats& run) {
  std::string text =
      fmt::format("{} {} {}: {} triangles, {} spans, {} pixels", run.scene, run.method, run.engine,
                  run.triangles, run.spans, run.counters.pixels);
  if (run.engine != "ideal") {
    text += fmt::format(", {} cycles ({:.3f} per pixel)", run.cycles, run.PixelCycles());
  }
  text += WorkText(run);
  if (run.comparison) text += ComparisonText(*run.comparison);
  text += ErrorText("Phong per pixel", run.phong_error);
  text += ErrorText("its closed form", run.closed_form_error);
  if (run.sim_seconds > 0) {
    text +=
        fmt::format("\n  {:.2f} s, {:.1f} M pixels/s", run.sim_seconds,
                    run.PixelsPerSecond() / 1e6);
  }
  return text;
}

bool ReportEmpty(const std::vector<RunStats>& runs) {
  const auto empty = std::find_if(runs.begin(), runs.end(),
                                  [](const RunStats& run) { return run.counters.pixels == 0; });
  if (empty == runs.end()) return false;
  fmt::print(stderr, "shadesim: {} {}: covers no pixel; turn or enlarge it\n", empty->scene,
             empty->method);
  return true;
}

}  // namespace shading::sim
