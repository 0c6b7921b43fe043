// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fstream>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace shading::sim {

// Finished parts of a long run, a JSON line each, so that a run that was stopped goes on where it
// was. The first line holds a fingerprint of what made the rest: with another fingerprint, or a
// first line that is none, nothing is kept. A line that was cut off is dropped. Thread-safe.
class Journal {
 public:
  using Json = nlohmann::ordered_json;

  // Throws std::runtime_error, one line, when the file cannot be written.
  Journal(const std::string& path, const std::string& fingerprint, bool fresh);

  std::optional<Json> Find(const std::string& id) const;
  void Append(const std::string& id, const Json& value);
  size_t kept() const { return kept_; }  // parts that were there at the start

 private:
  void Read(const std::string& fingerprint);

  const std::string path_;
  std::map<std::string, Json> parts_;
  size_t kept_ = 0;
  std::ofstream file_;
  mutable std::mutex mutex_;
};

}  // namespace shading::sim
