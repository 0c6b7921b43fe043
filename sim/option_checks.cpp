// SPDX-License-Identifier: Apache-2.0
#include "sim/option_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "sim/io/atomic_file.h"
#include "sim/io/image_io.h"
#include "sim/option_words.h"

namespace shading::sim {
namespace {

namespace fs = std::filesystem;

void CheckScenes(const Options& o) {
  if (o.scenes.empty() && o.random == 0) {
    Refuse(o.command == Command::kVerify ? "name a SCENE or --random N" : "name a SCENE");
  }
  if (o.random == 0) return;
  if (!o.scenes.empty()) Refuse("take a SCENE or --random N, not both");
  if (o.view_given) {
    Refuse(
        "--random N draws frames of its own size, camera and light: leave out the options that "
        "set them");
  }
}

void CheckTrace(const Options& o, bool one_run) {
  if (o.trace.empty()) return;
  if (!one_run) Refuse("--trace takes one SCENE and one --method");
  if (fs::path(o.trace).extension() != ".fst") {
    Refuse(fmt::format("--trace writes .fst files, not '{}'", o.trace));
  }
  if (o.engine != Engine::kRtl) Refuse("--trace needs --engine rtl");
}

// Files of results, but for pictures of several scenes or methods.
std::vector<std::string> Files(const Options& o) {
  std::vector<std::string> files;
  for (const std::string& file :
       {o.image, o.error_map, o.json, o.csv, o.trace, o.triangles_out, o.markdown}) {
    if (!file.empty()) files.push_back(file);
  }
  return files;
}

void CheckNames(const Options& o) {
  std::vector<std::string> files = o.scenes;
  for (const std::string& file : Files(o)) {
    if (std::find(files.begin(), files.end(), file) != files.end()) {
      Refuse(fmt::format("{} would be overwritten: give each file its own name", file));
    }
    files.push_back(file);
  }
}

}  // namespace

void CheckOptions(const Options& o) {
  if (o.command == Command::kList || o.command == Command::kStress) return;
  CheckScenes(o);
  const bool one_run = o.scenes.size() == 1 && o.OneMethod();
  CheckTrace(o, one_run);
  if (o.engine == Engine::kIdeal && (o.backpressure_given || o.lanes != 1)) {
    Refuse("--engine ideal has no cycles: leave out --backpressure and --lanes");
  }
  const bool paper = o.OneMethod() && o.methods[0] == Method::kSlerpPaper;
  if (o.fraction_bits != Quantity::kFraction && !(paper && o.engine == Engine::kModel)) {
    Refuse("--fraction-bits below 38 takes --method slerp-paper and --engine model");
  }
  if (!o.error_map.empty() && !one_run) Refuse("--error-map takes one SCENE and one --method");
  if (!o.triangles_out.empty() && o.scenes.size() != 1) Refuse("--triangles-out takes one SCENE");
  CheckNames(o);
  o.Sink();
}

void CheckOutputs(const Options& o) {
  for (const std::string& picture : {o.image, o.error_map}) {
    if (!picture.empty()) CheckImageExtension(picture);
  }
  for (const std::string& file : Files(o)) CheckWritable(file);
  std::error_code ignored;
  if (!o.out.empty() && fs::is_directory(o.out, ignored)) {
    CheckWritable((fs::path(o.out) / "report.html").string());
  }
}

}  // namespace shading::sim
