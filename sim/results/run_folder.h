// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace shading::sim {

using Json = nlohmann::ordered_json;

// What scripts/results.sh left in a folder: run.json says which commands ran, and each of them
// wrote a file. All must come from one version of the program on one machine. Throws
// std::runtime_error, one line, for a file that is missing, cut off or of another program.
class RunFolder {
 public:
  struct Step {
    std::string file, command;
    double seconds = 0;  // wall time
  };

  explicit RunFolder(std::filesystem::path folder);

  const Json& Read(const std::string& file);
  // Calls use(Json) with the file; what is missing in it is an error of the file.
  template <typename Use>
  auto With(const std::string& file, const Use& use) {
    const Json& json = Read(file);
    try {
      return use(json);
    } catch (const std::exception& error) {
      Refuse(file, error.what());
    }
  }

  // The step that wrote a file, its command without what only says where the output goes.
  const Step& StepOf(const std::string& file) const;
  // Steps whose file begins so.
  std::vector<Step> StepsOf(const std::string& prefix) const;

  const std::string& machine() const { return machine_; }
  const std::string& version() const { return version_; }
  const std::string& revision() const { return revision_; }
  bool quick() const { return quick_; }
  const std::string& synthesis() const { return synthesis_; }            // a file, or empty
  const std::string& synthesis_note() const { return synthesis_note_; }  // why it is empty

 private:
  [[noreturn]] void Refuse(const std::string& file, std::string reason) const;
  void CheckOrigin(const std::string& file, const Json& json);

  const std::filesystem::path folder_;
  std::map<std::string, Json> files_;
  std::vector<Step> steps_;
  std::string machine_, version_, revision_, synthesis_, synthesis_note_;
  std::string first_;  // file that machine and version come from
  bool quick_ = false;
};

}  // namespace shading::sim
