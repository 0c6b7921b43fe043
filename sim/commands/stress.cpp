// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "sim/commands/commands.h"
#include "sim/io/atomic_file.h"
#include "sim/parallel.h"
#include "sim/progress.h"
#include "sim/stress/stress_page.h"

namespace shading::sim {
namespace {

namespace fs = std::filesystem;
using stress::Check;
using stress::Finding;

void WriteWhole(const fs::path& path, const std::string& text) {
  AtomicFile file(path.string());
  file.stream() << text;
  file.Commit();
}

// Without a unit that is narrowed all are searched; with one only that, or all of them narrowed.
std::vector<Finding> Plan(const std::string& narrow) {
  std::vector<Finding> plan;
  for (const Check& check : stress::AllChecks()) {
    if (narrow.empty() || narrow == "all" || narrow == check.unit)
      plan.push_back({check, {}, narrow.empty() ? 0 : 1});
  }
  if (plan.empty())
    throw std::runtime_error(
        fmt::format("--narrow {}: no unit of that name is searched; see docs/stress.md", narrow));
  return plan;
}

int64_t Evaluations(const Check& check, bool quick) {
  return std::max<int64_t>((quick ? 1000000 : 20000000) / check.cost, 24);
}

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

}  // namespace

int Stress(const Options& options) {
  if (!options.replay.empty()) return Replay(options.replay);
  if (options.out.empty())
    throw std::runtime_error("stress: --out DIR or --replay FILE is required");
  const fs::path out = options.out;
  std::error_code error;
  fs::create_directories(out, error);
  if (error || !fs::is_directory(out))
    throw std::runtime_error(fmt::format("{}: not a folder and cannot be made one", options.out));
  stress::StressResults results;
  results.version = SHADESIM_VERSION;
  results.command = options.command_line;
  results.seed = options.seed;
  results.findings = Plan(options.narrow);
  const int count = static_cast<int>(results.findings.size());
  const bool plots = options.narrow.empty();
  Progress progress("stress", count + 3 * plots, options.quiet);
  ParallelFor(options.jobs, count + 3 * plots, [&](int i) {
    if (i < count) {
      Finding& f = results.findings[static_cast<size_t>(i)];
      f.worst = stress::Search(f.check, Evaluations(f.check, options.quick),
                               options.seed + static_cast<uint32_t>(i), f.narrow);
    } else if (i == count) {
      results.growth = stress::GrowthCurves(options.quick);
    } else {
      auto& map = i == count + 1 ? results.slerp : results.paper;
      map = stress::HeatMap(i != count + 1, i == count + 1 ? 38 : 20, options.quick);
    }
    progress.Step();
  });
  int broken = 0;
  for (const Finding& f : results.findings) {
    WriteWhole(out / (f.check.unit + ".worst.jsonl"), stress::WorstLine(f, options.seed) + "\n");
    broken += f.Broken();
    if (options.quiet && !f.Broken()) continue;
    fmt::print("{:22} {:>12.6g} of {:>10.6g} {:30} {:6.3f} {}\n", f.check.unit, f.worst.error,
               f.check.bound, UnitOf(f.check), f.Share(), f.Broken() ? "BROKEN" : "");
  }
  WriteWhole(out / "stress.json", stress::StressJson(results).dump(1) + "\n");
  WriteWhole(out / "report.html", stress::StressPage(results));
  if (!options.quiet)
    fmt::print("{} of {} bounds broken; seed {}; {}\n", broken, count, options.seed,
               (out / "report.html").string());
  return broken > 0;
}

}  // namespace shading::sim
