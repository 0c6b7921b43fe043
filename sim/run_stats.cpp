// SPDX-License-Identifier: Apache-2.0
#include "sim/run_stats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/io/atomic_file.h"

namespace shading::sim {
namespace {

using Json = nlohmann::ordered_json;

double PerPixel(const RunStats& run) {
  return run.counters.pixels > 0
             ? static_cast<double>(run.cycles) / static_cast<double>(run.counters.pixels)
             : 0;
}

double PixelsPerSecond(const RunStats& run) {
  return run.sim_seconds > 0 ? static_cast<double>(run.counters.pixels) / run.sim_seconds : 0;
}

void PutError(const PictureError& error, const std::string& prefix, Json* json) {
  (*json)[prefix + "max_error_lsb"] = error.max_lsb;
  (*json)[prefix + "rms_error_lsb"] = error.rms_lsb;
  // JSON has no infinity: null where the pictures agree.
  (*json)[prefix + "psnr_db"] = std::isfinite(error.psnr_db) ? Json(error.psnr_db) : Json();
}

// Cycles: null where the engine does not measure them.
void PutCycles(const RunStats& run, Json* json) {
  const bool timed = run.engine != "ideal";
  (*json)["cycles"] = timed ? Json(run.cycles) : Json();
  (*json)["cycles_per_pixel"] = timed ? Json(PerPixel(run)) : Json();
  (*json)["setup_cycles"] = timed ? Json(run.counters.setup) : Json();
  (*json)["stall_cycles"] = timed ? Json(run.counters.stall) : Json();
}

void PutComparison(const Comparison& comparison, Json* json) {
  (*json)["pixels_compared"] = comparison.pixels_compared;
  (*json)["pixels_expected"] = comparison.pixels_expected;
  (*json)["pixel_mismatches"] = comparison.pixel_mismatches;
  (*json)["spans_compared"] = comparison.spans_compared;
  (*json)["spans_expected"] = comparison.spans_expected;
  (*json)["cycle_mismatches"] = comparison.cycle_mismatches;
  (*json)["bad_frames"] = comparison.bad_frames;
}

Json ToJson(const RunStats& run) {
  Json json;
  json["scene"] = run.scene;
  json["method"] = run.method;
  json["engine"] = run.engine;
  json["width"] = run.width;
  json["height"] = run.height;
  json["triangles"] = run.triangles;
  json["spans"] = run.spans;
  json["pixels"] = run.counters.pixels;
  PutCycles(run, &json);
  json["skipped"] = {{"back_facing", run.skipped.back_facing},
                     {"degenerate", run.skipped.degenerate},
                     {"off_screen", run.skipped.off_screen},
                     {"empty", run.skipped.empty}};
  json["unlit"] = run.counters.unlit;
  json["no_highlight"] = run.counters.no_highlight;
  json["normalised"] = run.counters.normalised;
  json["normalisations_skipped"] = run.counters.skipped;
  json["samples_taken"] = run.counters.samples_taken;
  json["samples_excluded"] = run.counters.samples_excluded;
  json["samples_saved"] = run.counters.samples_saved;
  json["split_spans"] = run.split_spans;
  json["over_limit_triangles"] = run.over_limit;
  json["pieces"] = run.pieces;
  json["lanes"] = run.lanes;
  if (run.comparison) PutComparison(*run.comparison, &json);
  if (run.phong_error) PutError(*run.phong_error, "", &json);
  if (run.closed_form_error) PutError(*run.closed_form_error, "closed_form_", &json);
  json["sim_seconds"] = run.sim_seconds;
  json["pixels_per_second"] = PixelsPerSecond(run);
  return json;
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

void RunStats::AddWork(const FrameWork& work, int64_t packets) {
  triangles += packets;
  spans += static_cast<int64_t>(work.spans.size());
  split_spans += work.split_spans;
  over_limit += work.over_limit;
  pieces += work.pieces;
  AddSkips(work.skipped, &skipped);
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
  counters.samples_taken += other.counters.samples_taken;
  counters.samples_excluded += other.counters.samples_excluded;
  counters.samples_saved += other.counters.samples_saved;
  split_spans += other.split_spans;
  over_limit += other.over_limit;
  pieces += other.pieces;
  AddSkips(other.skipped, &skipped);
  sim_seconds += other.sim_seconds;
  if (other.comparison) {
    if (!comparison) comparison.emplace();
    comparison->Add(*other.comparison);
  }
  KeepWorst(other.phong_error, &phong_error);
  KeepWorst(other.closed_form_error, &closed_form_error);
}

void WriteJson(const std::string& path, const std::vector<RunStats>& runs) {
  RunStats total;
  total.scene = runs.size() == 1 ? runs[0].scene : "all";
  total.engine = runs[0].engine;
  total.method = runs[0].method;
  total.width = runs[0].width;
  total.height = runs[0].height;
  total.lanes = runs[0].lanes;
  for (const RunStats& run : runs) {
    if (run.method != total.method) total.method = "all";
    if (run.width != total.width || run.height != total.height) total.width = total.height = 0;
    total.Add(run);
  }
  Json json = ToJson(total);
  for (const RunStats& run : runs) json["runs"].push_back(ToJson(run));
  AtomicFile file(path);
  file.stream() << json.dump(2) << '\n';
  file.Commit();
}

std::string Summary(const RunStats& run) {
  std::string text =
      fmt::format("{} {} {}: {} triangles, {} spans, {} pixels", run.scene, run.method, run.engine,
                  run.triangles, run.spans, run.counters.pixels);
  if (run.engine != "ideal") {
    text += fmt::format(", {} cycles ({:.3f} per pixel)", run.cycles, PerPixel(run));
  }
  text += WorkText(run);
  if (run.comparison) text += ComparisonText(*run.comparison);
  text += ErrorText("Phong per pixel", run.phong_error);
  text += ErrorText("its closed form", run.closed_form_error);
  if (run.sim_seconds > 0) {
    text +=
        fmt::format("\n  {:.2f} s, {:.1f} M pixels/s", run.sim_seconds, PixelsPerSecond(run) / 1e6);
  }
  return text;
}

}  // namespace shading::sim
