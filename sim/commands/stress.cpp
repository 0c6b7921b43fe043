// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "sim/bench/fingerprint.h"
#include "sim/bench/journal.h"
#include "sim/commands/commands.h"
#include "sim/io/atomic_file.h"
#include "sim/io/packet_file.h"
#include "sim/machine.h"
#include "sim/parallel.h"
#include "sim/progress.h"
#include "sim/stress/stress_page.h"

namespace shading::sim {
namespace {

namespace fs = std::filesystem;
using stress::Check;
using stress::Finding;
using stress::Part;

// "codes", or "x 2^-24".
std::string UnitOf(const Check& check) {
  return check.ulp == std::string("codes") ? "codes" : fmt::format("x {}", check.ulp);
}

int Replay(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  int broken = 0, lines = 0;
  for (std::string line; std::getline(file, line); ++lines) {
    const auto text = nlohmann::json::parse(line, nullptr, false);
    if (!text.is_object() || text.value("format", "") != "shadesim-stress-case" ||
        !text.contains("operands"))
      throw std::runtime_error(
          fmt::format("{}:{}: not a case of shadesim stress", path, lines + 1));
    bool found = false;
    for (const Check& check : stress::AllChecks()) {
      if (check.unit != text.value("unit", "")) continue;
      stress::Genes genes;
      for (const auto& operand : text["operands"]) genes.push_back(operand.value("value", 0.0));
      if (genes.size() != check.genes.size()) break;
      const double error = check.error(genes, text.value("narrow", 0));
      fmt::print("{}: {:.6g} of {:.6g} {}\n", check.unit, error, check.bound, UnitOf(check));
      broken += error > check.bound;
      found = true;
    }
    if (!found)
      throw std::runtime_error(
          fmt::format("{}:{}: unknown unit or wrong number of operands", path, lines + 1));
  }
  if (lines == 0) throw std::runtime_error(fmt::format("{}: holds no case", path));
  return broken > 0;
}

// The folder of the results, made when it is not there.
fs::path Folder(const std::string& name) {
  std::error_code error;
  fs::create_directories(name, error);
  if (error || !fs::is_directory(name))
    throw std::runtime_error(fmt::format("{}: not a folder and cannot be made one", name));
  return name;
}

// Runs the parts that an earlier run did not finish, then takes all of them.
void RunParts(const Options& options, const fs::path& out, const std::vector<Part>& parts) {
  const std::string file = (out / "stress-parts.jsonl").string();
  Journal journal(file,
                  fmt::format("{} {} seed {} {}", ProgramFingerprint(),
                              options.quick ? "quick" : "full", options.seed, options.narrow),
                  options.fresh || options.quick);
  if (journal.kept() > 0 && !options.quiet)
    fmt::print("kept {} of {} parts of {}; --fresh searches anew\n", journal.kept(), parts.size(),
               file);
  std::vector<stress::PartJson> done(parts.size());
  Progress progress("stress", static_cast<int64_t>(parts.size()), options.quiet);
  ParallelFor(options.jobs, static_cast<int>(parts.size()), [&](int k) {
    const auto i = static_cast<size_t>(k);
    if (const auto kept = journal.Find(parts[i].id)) {
      done[i] = *kept;
    } else {
      done[i] = parts[i].run();
      journal.Append(parts[i].id, done[i]);
    }
    progress.Step();
  });
  for (size_t i = 0; i < parts.size(); ++i) parts[i].take(done[i]);
}

void WriteCase(const fs::path& out, const Finding& f, uint32_t seed) {
  WriteWhole(out / (f.check.unit + ".worst.jsonl"), stress::WorstLine(f, seed) + "\n");
  if (!f.check.triangle || f.worst.genes.empty()) return;
  if (const auto list = f.check.triangle(f.worst.genes))
    WritePackets((out / (f.check.unit + ".worst.triangles.jsonl")).string(), *list);
}

void Print(const stress::StressResults& results, bool quiet) {
  for (const Finding& f : results.findings) {
    if (quiet && !f.Broken()) continue;
    fmt::print("{:22} {:>12.6g} of {:>10.6g} {:30} {:6.3g} {}\n", f.check.unit, f.worst.error,
               f.check.bound, UnitOf(f.check), f.Share(), f.Broken() ? "BROKEN" : "");
  }
  for (const stress::Condition& c : results.conditions) {
    if (quiet && !c.Broken()) continue;
    fmt::print("{:.4g} of {:.4g}: {}: {} {}\n", c.worst, c.limit, c.scene, c.measure,
               c.Broken() ? "BROKEN" : "");
  }
}

}  // namespace

int Stress(const Options& options) {
  if (!options.replay.empty()) return Replay(options.replay);
  if (options.out.empty())
    throw std::runtime_error("stress: --out DIR or --replay FILE is required");
  stress::StressResults results;
  results.version = SHADESIM_VERSION;
  results.command = options.command_line;
  results.machine = DescribeMachine();
  results.seed = options.seed;
  results.quick = options.quick;
  const std::vector<Part> parts = stress::PartsOf(options.narrow, &results);
  if (parts.empty())
    throw std::runtime_error(fmt::format(
        "--narrow {}: no unit of that name is searched; see docs/stress.md", options.narrow));
  const fs::path out = Folder(options.out);
  RunParts(options, out, parts);
  for (const Finding& f : results.findings) WriteCase(out, f, options.seed);
  WriteWhole(out / "stress.json", stress::StressJson(results).dump(1) + "\n");
  WriteWhole(out / "report.html", stress::StressPage(results));
  Print(results, options.quiet);
  if (!options.quiet)
    fmt::print("{} broken of {} bounds and {} conditions; seed {}; {}\n", results.Broken(),
               results.findings.size(), results.conditions.size(), options.seed,
               (out / "report.html").string());
  return results.Broken() > 0;
}

}  // namespace shading::sim
