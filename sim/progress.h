// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <mutex>
#include <string>

namespace shading::sim {

// A bar on stderr for work of more than two seconds; silent when stderr is no terminal or when
// asked to be quiet. Thread-safe.
class Progress {
 public:
  Progress(std::string what, int64_t total, bool quiet);
  ~Progress();  // clears the line
  void Step();

 private:
  void Draw();

  const std::string what_;
  const int64_t total_;
  const bool enabled_;
  const std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point drawn_;
  std::mutex mutex_;
  int64_t done_ = 0;
  bool visible_ = false;
};

}  // namespace shading::sim
