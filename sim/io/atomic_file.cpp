// SPDX-License-Identifier: Apache-2.0
#include "sim/io/atomic_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

namespace shading::sim {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void Fail(const std::string& path, const std::string& what) {
  throw std::runtime_error(fmt::format("{}: {}", path, what));
}

bool StartsWith(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

// /dev/stdout may lead to a regular file that the shell holds open: renaming would leave the shell
// with the old one. /dev/shm holds ordinary files.
bool IsBelowDev(const std::string& path) {
  return (StartsWith(path, "/dev/") && !StartsWith(path, "/dev/shm/")) ||
         StartsWith(path, "/proc/");
}

// The file behind symbolic links, in a folder that exists.
fs::path Resolve(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) Fail(path, "is a folder; give a file name");
  fs::path target = path;
  if (fs::is_symlink(path, error)) target = fs::weakly_canonical(path, error);
  if (target.empty()) target = path;
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error)) {
    Fail(path, fmt::format("cannot be written, no folder '{}'; create it", folder.string()));
  }
  return target;
}

}  // namespace

void WriteWhole(const fs::path& path, const std::string& text) {
  AtomicFile file(path.string());
  file.stream() << text;
  file.Commit();
}

void CheckWritable(const std::string& path) {
  std::error_code ignored;
  const bool special = fs::exists(path, ignored) && !fs::is_regular_file(path, ignored) &&
                       !fs::is_directory(path, ignored);
  if (!special && !IsBelowDev(path)) AtomicFile file(path);
}

AtomicFile::AtomicFile(const std::string& path) : path_(path) {
  std::error_code ignored;
  target_ = IsBelowDev(path) ? fs::path(path) : Resolve(path);
  temporary_ = target_;
  const bool special = fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored);
  if (!special && !IsBelowDev(path)) temporary_ += ".tmp";
  stream_.open(temporary_, std::ios::binary | std::ios::trunc);
  if (!stream_) {
    Fail(path_, fmt::format("cannot be written ({}); choose another folder",
                            std::generic_category().message(errno)));
  }
}

AtomicFile::~AtomicFile() {
  if (!stream_.is_open()) return;
  stream_.close();
  RemoveTemporary();
}

void AtomicFile::Commit() {
  const bool flushed = static_cast<bool>(stream_.flush());
  stream_.close();
  if (!flushed || !stream_) {
    RemoveTemporary();
    Fail(path_, "could not be written in full; free some space on the disk");
  }
  if (temporary_ == target_) return;
  std::error_code error;
  fs::rename(temporary_, target_, error);
  if (!error) return;
  RemoveTemporary();
  Fail(path_, fmt::format("cannot be written ({}); choose another name", error.message()));
}

void AtomicFile::RemoveTemporary() {
  std::error_code ignored;
  if (temporary_ != target_) fs::remove(temporary_, ignored);
}

}  // namespace shading::sim
