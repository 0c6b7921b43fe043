// SPDX-License-Identifier: Apache-2.0
#include "sim/machine.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <thread>

namespace shading::sim {
namespace {

// What stands behind `key` in a file of "key: value" or key="value" lines, or `otherwise`.
std::string Find(const char* path, const std::string& key, const std::string& otherwise) {
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (line.compare(0, key.size(), key) != 0) continue;
    const size_t from = line.find_first_not_of(" \t:=\"", key.size());
    if (from == std::string::npos) continue;
    return line.substr(from, line.find_last_not_of(" \"") + 1 - from);
  }
  return otherwise;
}

// "16 GB", rounded; /proc/meminfo counts in KiB.
std::string Memory() {
  const double kib = std::atof(Find("/proc/meminfo", "MemTotal", "0").c_str());
  return kib > 0 ? fmt::format("{:.0f} GB", kib * 1024 / 1e9) : "unknown memory";
}

}  // namespace

std::string DescribeMachine() {
  return fmt::format("{} cores of {}, {}, {}, g++ {}, Verilator {}",
                     std::thread::hardware_concurrency(),
                     Find("/proc/cpuinfo", "model name", "an unnamed processor"), Memory(),
                     Find("/etc/os-release", "PRETTY_NAME", "an unnamed system"), __VERSION__,
                     SHADESIM_VERILATOR_VERSION);
}

}  // namespace shading::sim
