// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/journal.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "sim/io/atomic_file.h"

namespace shading::sim {

void Journal::Read(const std::string& fingerprint) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path_, ignored)) return;  // a device may have no end
  std::ifstream file(path_);
  std::string line;
  if (!std::getline(file, line)) return;
  const Json head = Json::parse(line, nullptr, false);
  if (!head.is_object() || !head.contains("fingerprint") || head["fingerprint"] != fingerprint)
    return;
  while (std::getline(file, line)) {
    const Json part = Json::parse(line, nullptr, false);
    if (part.is_object() && part.contains("id") && part.contains("value") &&
        part["id"].is_string()) {
      parts_[part["id"].get<std::string>()] = part["value"];
    }
  }
}

Journal::Journal(const std::string& path, const std::string& fingerprint, bool fresh)
    : path_(path) {
  if (!fresh) Read(fingerprint);
  kept_ = parts_.size();
  // Written anew, so that a line that was cut off does not run into the next.
  AtomicFile whole(path_);
  whole.stream()
      << Json{{"format", "shadesim-journal"}, {"version", 1}, {"fingerprint", fingerprint}}.dump()
      << '\n';
  for (const auto& [id, value] : parts_) {
    whole.stream() << Json{{"id", id}, {"value", value}}.dump() << '\n';
  }
  whole.Commit();
  file_.open(path_, std::ios::app);
}

std::optional<Journal::Json> Journal::Find(const std::string& id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto at = parts_.find(id);
  if (at == parts_.end()) return std::nullopt;
  return at->second;
}

void Journal::Append(const std::string& id, const Json& value) {
  const std::lock_guard<std::mutex> lock(mutex_);
  parts_[id] = value;
  file_ << Json{{"id", id}, {"value", value}}.dump() << '\n' << std::flush;
  if (!file_) {
    throw std::runtime_error(
        fmt::format("{}: could not be written in full; free some space on the disk", path_));
  }
}

}  // namespace shading::sim
