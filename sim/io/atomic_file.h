// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>

namespace shading::sim {

// A file that is whole or absent: it is written as FILE.tmp and renamed by Commit(). Without
// Commit() the temporary file is removed and FILE stays as it was. A symbolic link is followed.
// Pipes and devices, such as /dev/stdout, are written directly.
// Throws std::runtime_error, one line with the file and the remedy.
class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  std::ostream& stream() { return stream_; }
  void Commit();

 private:
  void RemoveTemporary();

  std::string path_;
  std::filesystem::path target_, temporary_;  // equal where the file is written directly
  std::ofstream stream_;
};

// The text as an AtomicFile.
void WriteWhole(const std::filesystem::path& path, const std::string& text);

// Throws what AtomicFile would, before the work that FILE is for. Pipes and devices are not opened.
void CheckWritable(const std::string& path);

}  // namespace shading::sim
