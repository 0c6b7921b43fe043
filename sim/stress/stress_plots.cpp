// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/stress_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/html.h"
#include "sim/report/plot.h"

namespace shading::stress {
namespace {

constexpr int kCellW = 46, kCellH = 22, kLeft = 76, kTop = 34;

template <typename Value>
size_t PlaceOf(const std::vector<Value>& values, Value value) {
  return static_cast<size_t>(std::find(values.begin(), values.end(), value) - values.begin());
}

std::string Short(double codes) {
  if (codes == 0) return "-";
  if (codes >= 100 && codes < 1000) return fmt::format("{:.0f}", codes);
  return codes >= 0.1 && codes < 100 ? fmt::format("{:.2g}", codes) : fmt::format("{:.0e}", codes);
}

}  // namespace

std::string GrowthPlot(const StressResults& r, const std::string& paper, int bits) {
  report::Plot plot(fmt::format("paper {}, {} fraction bits", paper, bits),
                    {"pixels of a span", true}, {"worst error, codes of 255", true}, 600, 340);
  int colour = 1;
  for (const Growth& g : r.growth) {
    if (g.fraction_bits == bits && g.paper == paper)
      plot.Add(report::Line{g.points, g.form, false, colour++, false});
  }
  return plot.Svg();
}

std::string WordPlot(const StressResults& r, const std::string& title, bool truncated) {
  report::Plot plot(title, {"fraction bits F", false}, {"worst error of 2048 pixels, codes", true},
                    600, 400);
  std::vector<std::string> forms;
  for (const Word& w : r.words) {
    // (2) evaluates what (3) steps, with the same roundings.
    const bool twin = w.form.find("(2)") != std::string::npos;
    if (!twin && PlaceOf(forms, w.form) == forms.size()) forms.push_back(w.form);
  }
  int colour = 0;
  for (const std::string& form : forms) {
    report::Line line;
    line.label = form;
    line.colour = colour++ % 8;
    for (const Word& w : r.words) {
      if (w.form == form) line.points.emplace_back(w.bits, truncated ? w.truncated : w.nearest);
    }
    plot.Add(line);
  }
  return plot.Svg();
}

std::string HeatSvg(const HeatMapOf& map) {
  std::vector<double> angles;
  std::vector<int> pixels;
  for (const Heat& c : map.cells) {
    if (PlaceOf(angles, c.degrees) == angles.size()) angles.push_back(c.degrees);
    if (PlaceOf(pixels, c.pixels) == pixels.size()) pixels.push_back(c.pixels);
  }
  const int width = kLeft + kCellW * static_cast<int>(pixels.size());
  const int height = kTop + kCellH * static_cast<int>(angles.size()) + 40;
  std::string svg = fmt::format(
      "<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" role=\"img\"><text "
      "class=\"title\" x=\"4\" y=\"16\">{2}</text>",
      width, height, report::EscapeHtml(map.title));
  for (const Heat& c : map.cells) {
    const double part = std::clamp((std::log10(std::max(c.codes, 1e-9)) + 6) / 8, 0.0, 1.0);
    const int x = kLeft + kCellW * static_cast<int>(PlaceOf(pixels, c.pixels));
    const int y = kTop + kCellH * static_cast<int>(PlaceOf(angles, c.degrees));
    svg += fmt::format(
        "<rect class=\"f6\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" opacity=\"{:.2f}\"/>"
        "<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
        x, y, kCellW - 1, kCellH - 1, c.codes == 0 ? 0 : 0.05 + 0.55 * part, x + kCellW / 2, y + 15,
        Short(c.codes));
  }
  for (size_t i = 0; i < angles.size(); ++i)
    svg += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{:g} deg</text>",
                       kLeft - 6, kTop + kCellH * static_cast<int>(i) + 15, angles[i]);
  for (size_t i = 0; i < pixels.size(); ++i)
    svg += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       kLeft + kCellW * static_cast<int>(i) + kCellW / 2, height - 26, pixels[i]);
  return svg + fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\">pixels of a span</text></svg>",
                           kLeft, height - 8);
}

}  // namespace shading::stress
