// SPDX-License-Identifier: Apache-2.0
#include "sim/results/run_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <stdexcept>
#include <utility>

namespace shading::sim {
namespace {

namespace fs = std::filesystem;

Json Parse(const fs::path& path) {
  std::error_code ignored;
  std::ifstream file(path);
  if (!file || fs::is_directory(path, ignored)) {
    throw std::runtime_error(
        fmt::format("{}: no such file; scripts/results.sh writes it", path.string()));
  }
  try {
    return Json::parse(file);
  } catch (const Json::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}: not JSON at byte {}; remove it and run scripts/results.sh again",
                    path.string(), error.byte));
  }
}

std::string WithoutOutputs(const std::string& command) {
  return std::regex_replace(command, std::regex(" --(quiet|(json|jobs|benchmark_out)[ =][^ ]+)"),
                            "");
}

}  // namespace

RunFolder::RunFolder(fs::path folder) : folder_(std::move(folder)) {
  With("run.json", [this](const Json& run) {
    if (run.at("format") != "shadesim-results" || run.at("version") != 1) {
      throw std::invalid_argument("format is not shadesim-results, version 1");
    }
    revision_ = run.at("revision");
    quick_ = run.at("quick");
    synthesis_ = run.at("synthesis");
    synthesis_note_ = run.at("synthesis_note");
    for (const Json& step : run.at("steps")) {
      steps_.push_back({step.at("file"), WithoutOutputs(step.at("command")), step.at("seconds")});
    }
  });
}

const Json& RunFolder::Read(const std::string& file) {
  const auto at = files_.find(file);
  if (at != files_.end()) return at->second;
  Json json = Parse(folder_ / file);
  if (!json.is_object()) Refuse(file, "no object");
  CheckOrigin(file, json);
  return files_[file] = std::move(json);
}

// Programs say who they are by "machine" and "shadesim"; others do not.
void RunFolder::CheckOrigin(const std::string& file, const Json& json) {
  if (!json.contains("machine")) return;
  const std::string machine = json.value("machine", ""), version = json.value("shadesim", "");
  if (first_.empty()) {
    first_ = file;
    machine_ = machine;
    version_ = version;
  } else if (machine != machine_ || version != version_) {
    Refuse(file, fmt::format("another machine or version than {}", first_));
  }
}

void RunFolder::Refuse(const std::string& file, std::string reason) const {
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw std::runtime_error(
      fmt::format("{}: not what scripts/results.sh wrote ({}); remove it and run that again",
                  (folder_ / file).string(), reason));
}

const RunFolder::Step& RunFolder::StepOf(const std::string& file) const {
  for (const Step& step : steps_) {
    if (step.file == file) return step;
  }
  Refuse("run.json", fmt::format("no step wrote {}", file));
}

std::vector<RunFolder::Step> RunFolder::StepsOf(const std::string& prefix) const {
  std::vector<Step> found;
  std::copy_if(steps_.begin(), steps_.end(), std::back_inserter(found),
               [&](const Step& step) { return step.file.rfind(prefix, 0) == 0; });
  return found;
}

}  // namespace shading::sim
