// SPDX-License-Identifier: Apache-2.0
#include "tb/wave_view.h"

#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace shading::tb {
namespace {

// A line that starts with '-' is a heading.
constexpr const char* kSignals[] = {
    "clk_i",
    "-frame",
    "frame_valid_i",
    "frame_ready_o",
    "-triangle",
    "triangle_valid_i",
    "triangle_ready_o",
    "-span",
    "span_valid_i",
    "span_ready_o",
    "span_i.x[11:0]",
    "span_i.y[11:0]",
    "span_i.length[12:0]",
    "span_i.last",
    "-seed",
    "seed_valid",
    "seed_ready",
    "-pixel",
    "pixel_valid_o",
    "pixel_ready_i",
    "pixel_o.x[11:0]",
    "pixel_o.y[11:0]",
    "pixel_o.z[23:0]",
    "pixel_o.r[7:0]",
    "pixel_o.g[7:0]",
    "pixel_o.b[7:0]",
    "pixel_o.last",
};

}  // namespace

std::string WriteWaveView(const std::string& waveform) {
  const std::filesystem::path path(waveform);
  const std::string name = std::filesystem::path(path).replace_extension(".gtkw").string();
  std::ofstream file(name);
  file << "[dumpfile] \"" << std::filesystem::absolute(path).string() << "\"\n[timestart] 0\n";
  for (const std::string signal : kSignals) {
    file << (signal[0] == '-' ? "@200\n" + signal : "@24\nTOP.shading_unit." + signal) << '\n';
  }
  file.close();
  if (!file) throw std::runtime_error(name + ": cannot be written; is the disk full?");
  return name;
}

}  // namespace shading::tb
