// SPDX-License-Identifier: Apache-2.0
#include "sim/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <utility>

namespace shading::sim {
namespace {
constexpr auto kPatience = std::chrono::seconds(2);
constexpr auto kRefresh = std::chrono::milliseconds(100);
constexpr int kWidth = 40;
}  // namespace

Progress::Progress(std::string what, int64_t total, bool quiet)
    : what_(std::move(what)),
      total_(total),
      enabled_(!quiet && total > 0 && isatty(STDERR_FILENO) != 0),
      start_(std::chrono::steady_clock::now()),
      drawn_(start_) {}

Progress::~Progress() {
  if (visible_) fmt::print(stderr, "\r{:{}}\r", "", static_cast<int>(what_.size()) + kWidth + 12);
}

void Progress::Step() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++done_;
  const auto now = std::chrono::steady_clock::now();
  if (!enabled_ || now - start_ < kPatience || now - drawn_ < kRefresh) return;
  drawn_ = now;
  visible_ = true;
  Draw();
}

void Progress::Draw() {
  const int filled = static_cast<int>(kWidth * done_ / total_);
  fmt::print(stderr, "\r{} [{:#<{}}{:{}}] {:3}%", what_, "", filled, "", kWidth - filled,
             100 * done_ / total_);
  std::fflush(stderr);
}

}  // namespace shading::sim
