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
};
constexpr const char* kPixelFields[] = {"x[11:0]", "y[11:0]", "z[23:0]", "r[7:0]",
                                        "g[7:0]",  "b[7:0]",  "last"};

}  // namespace

std::string WriteWaveView(const std::string& waveform, int lanes) {
  const std::filesystem::path path(waveform);
  const std::string name = std::filesystem::path(path).replace_extension(".gtkw").string();
  std::ofstream file(name);
  file << "[dumpfile] \"" << std::filesystem::absolute(path).string() << "\"\n[timestart] 0\n";
  const auto show = [&file](const std::string& signal) {
    file << "@24\nTOP.shading_unit." << signal << '\n';
  };
  for (const std::string signal : kSignals) {
    if (signal[0] == '-') {
      file << "@200\n" << signal << '\n';
    } else {
      show(signal);
    }
  }
  for (int lane = 0; lane < lanes; ++lane) {
    for (const char* field : kPixelFields) {
      show("pixel_o[" + std::to_string(lane) + "]." + field);
    }
  }
  file.close();
  if (!file) throw std::runtime_error(name + ": cannot be written; is the disk full?");
  return name;
}

}  // namespace shading::tb
