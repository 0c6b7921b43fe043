// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "sim/io/atomic_file.h"
#include "sim/machine.h"
#include "sim/run_stats.h"

namespace shading::sim {
namespace {

using Json = nlohmann::ordered_json;

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
  (*json)["cycles_per_pixel"] = timed ? Json(run.PixelCycles()) : Json();
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

// What an auto frame shaded by which method, and what it left out.
void PutChoices(const RunStats& run, Json* json) {
  Json& skipped = (*json)["skipped"];
  skipped["ambient_only"] = run.counters.ambient;
  skipped["constant_spans"] = run.counters.constant;
  skipped["dark_spans"] = run.counters.dark;
  skipped["unnormalised_spans"] = run.counters.unnormalised;
  skipped["black_channels"] = run.counters.black;
  for (const Method method : kAllMethods) {
    const MethodShare& share = run.share[static_cast<size_t>(method)];
    if (share.triangles == 0) continue;
    (*json)["chosen"][std::string(Name(method))] = {
        {"triangles", share.triangles}, {"spans", share.spans}, {"pixels", share.pixels}};
  }
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
  if (run.method == Name(Method::kAuto)) PutChoices(run, &json);
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
  json["pixels_per_second"] = run.PixelsPerSecond();
  return json;
}

}  // namespace

void WriteJson(const std::string& path, const std::string& command,
               const std::vector<RunStats>& runs) {
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
  json["command"] = command;
  json["shadesim"] = SHADESIM_VERSION;
  json["machine"] = DescribeMachine();
  for (const RunStats& run : runs) json["runs"].push_back(ToJson(run));
  AtomicFile file(path);
  file.stream() << json.dump(2) << '\n';
  file.Commit();
}

}  // namespace shading::sim
