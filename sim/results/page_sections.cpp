// SPDX-License-Identifier: Apache-2.0
#include "sim/results/page_sections.h"

#include <fmt/format.h>

#include "sim/bench/auto_table.h"
#include "sim/bench/bench_json.h"
#include "sim/bench/bench_tables.h"
#include "sim/bench/claims.h"
#include "sim/results/run_tables.h"
#include "sim/results/stress_tables.h"

namespace shading::sim {
namespace {

using report::Entry;
using report::Table;

constexpr const char* kBench = "bench/bench.json";
constexpr const char* kStress = "stress/stress.json";
constexpr const char* kNarrow = "narrow/stress.json";
constexpr double kModelGoal = 20;  // times the RTL's speed

std::string By(const RunFolder& folder, const std::string& file) {
  return fmt::format("`{}`", folder.StepOf(file).command);
}

// "by COMMAND: words", then the table.
std::string Section(const std::string& by, const std::string& words, const Table& table) {
  return fmt::format("{}{}{}\n\n{}", by, words.empty() ? "" : ": ", words, table.Markdown());
}

std::string HeadOf(const RunFolder& folder) {
  return fmt::format("shadesim {}, revision {}, on {}.{}\n", folder.version(), folder.revision(),
                     folder.machine(),
                     folder.quick() ? "\n\n**A quick run**: fewer triangles, smaller pictures and "
                                      "shorter searches than a full one."
                                    : "");
}

std::string StepsOf(const RunFolder& folder) {
  Table table({"command", "wall time, s"});
  for (const RunFolder::Step& step : folder.StepsOf("")) {
    table.Add({fmt::format("`{}`", step.command),
               Entry(step.seconds, fmt::format("{:.0f}", step.seconds))});
  }
  return table.Markdown();
}

std::string VerifyOf(RunFolder* folder) {
  std::vector<std::pair<std::string, Json>> files;
  for (const RunFolder::Step& step : folder->StepsOf("verify-")) {
    files.emplace_back(step.command, folder->Read(step.file));
    // One by one, so that the file at fault is named.
    folder->With(step.file, [&](const Json& json) { return VerifyTable({{"", json}}); });
  }
  return VerifyTable(files).Markdown();
}

void AddFrames(RunFolder* folder, Sections* sections) {
  (*sections)["work"] = folder->With(
      "cycles-1.json", [](const Json& cycles) { return WorkTable(cycles).Markdown(); });
  (*sections)["cycles"] = folder->With("cycles-4.json", [&](const Json& four) {
    const Json& one = folder->Read("cycles-1.json");
    const Json& run = one.at("runs").at(0);
    return Section(fmt::format("{} and `--lanes 4`", By(*folder, "cycles-1.json")),
                   fmt::format("{} spans, {} pixels, {:.1f} a span.",
                               run.at("spans").get<int64_t>(), run.at("pixels").get<int64_t>(),
                               run.at("pixels").get<double>() / run.at("spans").get<double>()),
                   FrameCycleTable(one, four));
  });
  (*sections)["errors"] = folder->With("errors.json", [&](const Json& render) {
    return Section(By(*folder, "errors.json"),
                   "LSB = 1/255, all covered pixels and channels, rounding of the code (1/2 LSB) "
                   "included.",
                   FrameErrorTable(render));
  });
}

void AddStress(RunFolder* folder, Sections* sections) {
  const Json& narrow = folder->Read(kNarrow);
  folder->With(kNarrow, [](const Json& json) { return BoundTable(json, json); });
  folder->With(kStress, [&](const Json& stress) {
    (*sections)["stress-bounds"] =
        Section(fmt::format("{} and {}", By(*folder, kStress), By(*folder, kNarrow)),
                BrokenWords(stress, narrow), BoundTable(stress, narrow));
    (*sections)["stress-rest"] = NotSearched(stress);
    (*sections)["stress-scenes"] = TroubleTable(stress).Markdown();
    (*sections)["stress-words"] = WordTable(stress).Markdown();
    return 0;
  });
}

void AddSpeed(RunFolder* folder, Sections* sections) {
  (*sections)["speed"] = folder->With("speed.json", [&](const Json& speed) {
    return fmt::format(
        "{}\n{}\n",
        Section(By(*folder, "speed.json"), "one core, M pixels per second.", SpeedTable(speed)),
        SpeedWords(speed, kModelGoal));
  });
}

// Of the whole shading unit: methods of the run that the file has no build of.
std::string NotBuilt(const Results& results) {
  std::string names;
  for (const Method method : results.methods) {
    for (const int lanes : {1, kMaxLanes}) {
      if (method == Method::kAuto || results.synthesis->Area(method, lanes)) continue;
      names += fmt::format("{}{}, {} lane{}", names.empty() ? "" : "; ", Name(method), lanes,
                           lanes > 1 ? "s" : "");
    }
  }
  return names.empty() ? "" : fmt::format("\nNot synthesised: {}.\n", names);
}

void AddSynthesis(const RunFolder& folder, const Results& results, Sections* sections) {
  const std::string missing = fmt::format("{}\n", folder.synthesis_note());
  (*sections)["synthesis-units"] = (*sections)["synthesis-builds"] = missing;
  if (!results.synthesis) return;
  const std::string by = fmt::format("`scripts/synth.sh --json {}`, {}, `{}`", folder.synthesis(),
                                     results.synthesis->tool, results.synthesis->target);
  (*sections)["synthesis-units"] = Section(by, "one lane.", UnitTable(*results.synthesis));
  (*sections)["synthesis-builds"] =
      Section(by, "", AreaTable(results, *results.synthesis)) + NotBuilt(results);
}

void AddBench(const RunFolder& folder, const Results& r, Sections* sections) {
  const std::string by = By(folder, kBench);
  const std::string& scene = r.scenes.back();
  const int n = r.shininess[r.shininess.size() / 2];
  const auto put = [&](const char* name, const std::string& words, const Table& table) {
    (*sections)[name] = Section(by, words, table);
  };
  put("spans",
      "spans of one length back to back, always ready, in steady state; latency is from a span "
      "taken to its first pixel on offer in an idle unit, one lane. Normals turn by 10 degrees "
      "along a span; adaptive methods: tolerance 0.5 LSB, n = 32.",
      SpanTable(r));
  put("fronts", fmt::format("{} scenes of {} x {} pixels.", r.scenes.size(), r.width, r.height),
      FrontTable(r, ErrorKind::kRms));
  (*sections)["fronts-max"] = FrontTable(r, ErrorKind::kMax).Markdown();
  put("software", fmt::format("{}, n = {}, one lane, processor time of one thread.", scene, n),
      ErrorTable(r, scene, n));
  put("auto", "one lane.", AutoTable(r));
  put("operations", "cycles are the papers': a product 8, an addition, a shift or a look-up 1.",
      OperationTable(r));
  put("claims", "ratios are geometric means over scenes and n, one lane.",
      report::ClaimTable(PaperClaims(r)));
}

}  // namespace

Sections MakeSections(RunFolder* folder) {
  Sections sections;
  Results results = folder->With(kBench, [](const Json& json) { return ResultsFromJson(json); });
  if (!folder->synthesis().empty()) results.synthesis = ReadSynthesis(folder->synthesis());
  AddBench(*folder, results, &sections);
  AddSynthesis(*folder, results, &sections);
  AddFrames(folder, &sections);
  AddStress(folder, &sections);
  AddSpeed(folder, &sections);
  sections["verify"] = VerifyOf(folder);
  sections["head"] = HeadOf(*folder);
  sections["steps"] = StepsOf(*folder);
  return sections;
}

}  // namespace shading::sim
