// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/stress_page.h"

#include <fmt/format.h>

#include "sim/report/page.h"
#include "sim/report/table.h"
#include "sim/stress/stress_plots.h"

namespace shading::stress {
namespace {

using report::Entry;

Entry Held(bool broken) {
  Entry entry(broken ? "BROKEN" : "yes");
  entry.strong = broken;
  return entry;
}

// JSON's stand-in for infinity is no number to print.
Entry Size(double value) { return value < 1e200 ? Entry(value) : Entry(value, "no number"); }

void Bounds(const StressResults& r, report::Page* page) {
  page->Section("Bounds and worst cases");
  page->Text(
      "Each unit's stated bound against the worst case that directed, random and hill-climbing "
      "search found. A search is no proof: found / bound near 1 shows a tight bound, above 1 a "
      "broken one. UNIT.worst.jsonl beside this page holds the case for --replay; of units that "
      "set up triangles, UNIT.worst.triangles.jsonl is the triangle for shadesim render and "
      "verify.");
  report::Table table({"unit", "worst found", "bound stated", "ulp", "found / bound", "held",
                       "cases", "valid for"});
  for (const Finding& f : r.findings) {
    table.Add({f.check.unit + (f.narrow > 0 ? ": " + f.check.narrowed : ""), Size(f.worst.error),
               f.check.bound, f.check.ulp, Entry(f.Share(), fmt::format("{:.3g}", f.Share())),
               Held(f.Broken()), Entry::Count(f.worst.evaluations), f.check.valid});
  }
  page->Markup(table.Html());
  page->Command(r.command);
  page->Section("Units without a search");
  report::Table rest({"unit", "why"});
  for (const Exempt& e : Exemptions()) rest.Add({e.unit, e.reason});
  page->Markup(rest.Html());
}

void Trouble(const StressResults& r, report::Page* page) {
  page->Section("Scenes of trouble");
  page->Text(
      "Conditions that must hold where arithmetic is hard: neighbours that leave no gap, slivers "
      "and needles, far and tiny triangles, normals that are nearly opposed, 4096 rows and then "
      "4096 columns, clamps and registers that wrap. Naive is what an obvious shortcut gives.");
  report::Table table({"kind", "scene", "measured", "worst", "limit", "naive", "held", "cases"});
  for (const Condition& c : r.conditions) {
    table.Add({c.family, c.scene, c.measure, Size(c.worst), c.limit,
               c.naive < 0 ? Entry("") : c.naive, Held(c.Broken()), Entry::Count(c.cases)});
  }
  page->Markup(table.Html());
}

void Words(const StressResults& r, report::Page* page) {
  page->Section("Word length and rounding");
  page->Text(
      "Worst pixel of 2048 with F fraction bits. Paper 000: unit amplitude, turns of 0.01 to 179 "
      "degrees, products to nearest or truncated. slerp_recurrence: F bits of its multiplier's "
      "operand, its state has 10 more. Paper 003: intensities in codes; the recurrences add, so "
      "start values and coefficients are what is rounded or truncated. Errors beyond 255 mean a "
      "picture of nothing.");
  page->Figure({WordPlot(r, "to nearest", false), WordPlot(r, "truncated", true)},
               "Half a code is 0.5: where a curve crosses it, the form has enough bits.",
               r.command);
  report::Table table({"form", "F", "to nearest, codes", "truncated, codes"});
  for (const Word& w : r.words)
    table.Add({w.form, static_cast<double>(w.bits), w.nearest, w.truncated});
  page->Markup("<div class=\"long\">" + table.Html() + "</div>");
  page->Subsection("Expected and measured here");
  page->Text(
      "Expected: another simulation of the same recurrences, the worst of its own sample of "
      "signals; "
      "for paper 000 and the scaled form the length of a vector's error, up to sqrt(3) times that "
      "of "
      "a component, which is measured here. Values of paper 003 are of one channel.");
  report::Table references({"case", "unit", "expected", "measured here", "measured / expected"});
  for (const Reference& f : r.references)
    references.Add({f.what, f.unit, f.expected, f.here, f.here / f.expected});
  page->Markup(references.Html());
}

void Growths(const StressResults& r, report::Page* page) {
  page->Section("Growth of the error along a span");
  page->Text(
      "Paper 000: worst pixel over turns of 0.01 to 150 degrees and several phases, against the "
      "closed form, amplitude 1. The multiplier of slerp_recurrence takes 10 bits less than its "
      "state has.");
  page->Figure(
      {GrowthPlot(r, "000", 14), GrowthPlot(r, "000", 20), GrowthPlot(r, "000", 26),
       GrowthPlot(r, "000", 32), GrowthPlot(r, "000", 38)},
      "Both axes are logarithmic. Every form grows with the square of the length; the scaled one "
      "starts from what its short operand loses.",
      r.command);
  page->Figure({GrowthPlot(r, "003", 20), GrowthPlot(r, "003", 26)},
               "Paper 003: start values and coefficients to nearest, in codes; the sums are exact.",
               r.command);
  page->Section("Angle against length");
  std::vector<std::string> maps;
  for (const HeatMapOf& map : r.heat) maps.push_back(HeatSvg(map));
  page->Figure(maps,
               "Worst error in codes of 255. A dash: a step is over a quarter of a turn and was "
               "not run.",
               r.command);
}

void DeadZones(report::Page* page) {
  page->Section("Dead zones");
  page->Text(
      "Below these turns the bend of a step is under half an ulp and the recurrence draws a "
      "straight line.");
  report::Table dead({"fraction bits", "64 pixels, deg", "256 pixels, deg", "2048 pixels, deg"});
  for (const int bits : {10, 14, 16, 20, 26, 32, 38})
    dead.Add(
        {static_cast<double>(bits), DeadZone(bits, 64), DeadZone(bits, 256), DeadZone(bits, 2048)});
  page->Markup(dead.Html());
}

}  // namespace

std::string StressPage(const StressResults& r) {
  report::Page page("Numerical stability", {fmt::format("shadesim {}, seed {}, {}", r.version,
                                                        r.seed, r.quick ? "quick" : "full"),
                                            r.machine, r.command});
  Bounds(r, &page);
  if (r.growth.empty()) return page.Html();
  Trouble(r, &page);
  Words(r, &page);
  Growths(r, &page);
  DeadZones(&page);
  return page.Html();
}

}  // namespace shading::stress
