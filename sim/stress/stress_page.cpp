// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/stress_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/report/html.h"
#include "sim/report/page.h"
#include "sim/report/plot.h"
#include "sim/report/table.h"

namespace shading::stress {
namespace {

using nlohmann::json;
using report::Significant;

json CaseOf(const Finding& f) {
  json genes = json::array();
  for (size_t i = 0; i < f.worst.genes.size(); ++i)
    genes.push_back({{"what", f.check.genes[i]}, {"value", f.worst.genes[i]}});
  return genes;
}

std::string GrowthPlot(const StressResults& r, int bits) {
  report::Plot plot(fmt::format("{} fraction bits", bits), {"pixels of a span", true},
                    {"worst error, codes of 255", true}, 400, 320);
  int colour = 1;
  for (const Growth& g : r.growth) {
    if (g.fraction_bits == bits) plot.Add(report::Line{g.points, g.form, false, colour++, false});
  }
  return plot.Svg();
}

// Decades of error from 1e-6 codes, pale, to 100, dark.
std::string HeatSvg(const std::vector<Heat>& cells, const std::string& title) {
  constexpr int kCellW = 44, kCellH = 24, kLeft = 70, kTop = 34;
  std::vector<double> angles;
  std::vector<int> pixels;
  for (const Heat& c : cells) {
    if (std::find(angles.begin(), angles.end(), c.degrees) == angles.end())
      angles.push_back(c.degrees);
    if (std::find(pixels.begin(), pixels.end(), c.pixels) == pixels.end())
      pixels.push_back(c.pixels);
  }
  const int width = kLeft + kCellW * static_cast<int>(pixels.size());
  const int height = kTop + kCellH * static_cast<int>(angles.size()) + 40;
  std::string svg = fmt::format(
      "<svg width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\"><text class=\"title\" x=\"4\" "
      "y=\"16\">{2}</text>",
      width, height, report::EscapeHtml(title));
  for (const Heat& c : cells) {
    const auto col = std::find(pixels.begin(), pixels.end(), c.pixels) - pixels.begin();
    const auto row = std::find(angles.begin(), angles.end(), c.degrees) - angles.begin();
    const double part = std::clamp((std::log10(std::max(c.codes, 1e-9)) + 6) / 8, 0.0, 1.0);
    const auto x = kLeft + kCellW * col, y = kTop + kCellH * row;
    svg += fmt::format(
        "<rect class=\"f6\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" opacity=\"{:.2f}\"/>", x,
        y, kCellW - 1, kCellH - 1, 0.05 + 0.55 * part);
    svg += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{:.0e}</text>",
                       x + kCellW / 2, y + 16, c.codes);
  }
  for (size_t i = 0; i < angles.size(); ++i)
    svg += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"end\">{:g} deg</text>",
                       kLeft - 6, kTop + kCellH * static_cast<int>(i) + 16, angles[i]);
  for (size_t i = 0; i < pixels.size(); ++i)
    svg += fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                       kLeft + kCellW * static_cast<int>(i) + kCellW / 2, height - 24, pixels[i]);
  return svg + fmt::format("<text class=\"soft\" x=\"{}\" y=\"{}\">pixels of a span</text></svg>",
                           kLeft, height - 6);
}

report::Table BoundTable(const StressResults& r) {
  report::Table table({"unit", "worst found", "bound stated", "ulp", "found / bound", "held",
                       "cases", "valid for"});
  for (const Finding& f : r.findings) {
    table.Add({f.check.unit + (f.narrow > 0 ? " (narrowed)" : ""), f.worst.error, f.check.bound,
               f.check.ulp, f.Share(), f.Broken() ? "BROKEN" : "yes",
               report::Entry::Count(f.worst.evaluations), f.check.valid});
  }
  return table;
}

}  // namespace

std::string WorstLine(const Finding& f, uint32_t seed) {
  return json{{"format", "shadesim-stress-case"},
              {"version", 1},
              {"unit", f.check.unit},
              {"narrow", f.narrow},
              {"seed", seed},
              {"error", f.worst.error},
              {"bound", f.check.bound},
              {"ulp", f.check.ulp},
              {"operands", CaseOf(f)}}
      .dump();
}

json StressJson(const StressResults& r) {
  json units = json::array();
  for (const Finding& f : r.findings) {
    units.push_back({{"unit", f.check.unit},
                     {"worst", f.worst.error},
                     {"bound", f.check.bound},
                     {"ulp", f.check.ulp},
                     {"worst_over_bound", f.Share()},
                     {"broken", f.Broken()},
                     {"evaluations", f.worst.evaluations},
                     {"narrow", f.narrow},
                     {"valid_for", f.check.valid},
                     {"operands", CaseOf(f)}});
  }
  json growth = json::array(), exempt = json::array();
  for (const Growth& g : r.growth)
    growth.push_back({{"form", g.form}, {"fraction_bits", g.fraction_bits}, {"points", g.points}});
  for (const Exempt& e : Exemptions()) exempt.push_back({{"unit", e.unit}, {"reason", e.reason}});
  return {{"version", r.version}, {"command", r.command}, {"seed", r.seed},
          {"units", units},       {"growth", growth},     {"not_searched", exempt}};
}

std::string StressPage(const StressResults& r) {
  report::Page page("Numerical stability",
                    {fmt::format("shadesim {}, seed {}", r.version, r.seed), r.command});
  page.Section("Bounds and worst cases");
  page.Text(
      "Each unit's stated bound against the worst case that directed, random and hill-climbing "
      "search found. A search is no proof: found / bound near 1 shows a tight bound, above 1 a "
      "broken one.");
  page.Markup(BoundTable(r).Html());
  page.Command(r.command);
  page.Section("Units without a search here");
  report::Table rest({"unit", "why"});
  for (const Exempt& e : Exemptions()) rest.Add({e.unit, e.reason});
  page.Markup(rest.Html());
  if (r.growth.empty()) return page.Html();
  page.Section("Growth of the error along a span");
  page.Text(
      "Worst pixel over turns of 0.01 to 150 degrees and several phases, against the closed form, "
      "amplitude 1. "
      "slerp_recurrence has a multiplier operand of 10 bits fewer, as the unit has.");
  page.Figure({GrowthPlot(r, 14), GrowthPlot(r, 20), GrowthPlot(r, 26), GrowthPlot(r, 32),
               GrowthPlot(r, 38)},
              "Both axes are logarithmic. The paper's form grows with the square of the length.",
              r.command);
  page.Section("Angle against length");
  page.Figure({HeatSvg(r.slerp, "slerp_recurrence, 38 fraction bits: worst error, codes"),
               HeatSvg(r.paper, "slerp_paper, 20 fraction bits: worst error, codes")},
              "0 where a step is over a quarter of a turn and was not run.", r.command);
  page.Section("Dead zones");
  page.Text(
      "Below these turns the bend of a step is under half an ulp and the recurrence draws a "
      "straight line.");
  report::Table dead({"fraction bits", "64 pixels, deg", "256 pixels, deg", "2048 pixels, deg"});
  for (const int bits : {10, 14, 16, 20, 26, 32, 38})
    dead.Add(
        {static_cast<double>(bits), DeadZone(bits, 64), DeadZone(bits, 256), DeadZone(bits, 2048)});
  page.Markup(dead.Html());
  return page.Html();
}

}  // namespace shading::stress
