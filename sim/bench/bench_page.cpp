// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/bench_page.h"

#include <fmt/format.h>

#include "sim/bench/auto_table.h"
#include "sim/bench/bench_plots.h"
#include "sim/bench/bench_tables.h"
#include "sim/report/html.h"
#include "sim/report/page.h"

namespace shading::sim {
namespace {

using report::Page;
using report::Significant;

std::string Again(const Results& r, const std::string& scenes) {
  return fmt::format("shadesim bench {} --size {}x{} --out DIR", scenes, r.width, r.height);
}

void AddFronts(const Results& r, Page* page) {
  page->Section("Which methods are on the front");
  page->Text(
      "Methods that no other beats in both run time and error, by scene and shininess n. Error is "
      "the RMS of the displayed codes against exact Blinn-Phong of the linear normal, 1 LSB = "
      "1/255, "
      "rounding of the code included: 0.29 LSB is a perfect picture. Errors "
      "are compared in steps of 0.01 LSB, costs in steps of 1 %, and equals share a place. Times "
      "of software vary "
      "between "
      "runs by some per cent, and so do methods that are close there.");
  page->Markup(FrontTable(r, ErrorKind::kRms).Html());
  page->Subsection("By the largest error of a pixel instead");
  page->Markup(FrontTable(r, ErrorKind::kMax).Html());
}

void AddPlots(const Results& r, Page* page) {
  page->Section("Run time against error");
  page->Text(
      "Both axes are logarithmic; better is left and down. On the front in colour, dominated grey; "
      "\"+3\" "
      "stands for three more methods in the same place, which the pointer names.");
  page->Markup(KindLegend());
  for (const std::string& scene : r.scenes) {
    page->Subsection(scene);
    for (const Face& face : kFaces) {
      if (face.kind == Face::Kind::kCyclesTimesArea && !r.synthesis) {
        page->Text(fmt::format("{}: {}.", face.name, r.synthesis_note));
        continue;
      }
      std::vector<std::string> plots;
      for (const int n : r.shininess) plots.push_back(ParetoPlot(r, face, scene, n));
      page->Figure(plots, fmt::format("{}. {}", face.name, face.what), Again(r, scene));
    }
  }
}

void AddSpans(const Results& r, Page* page) {
  page->Section("Cycles per span");
  page->Text(
      "Spans of one length back to back, pixels taken in every cycle, in steady state. A span "
      "costs its "
      "pixels, or its set-up where that is longer. Latency is from a span taken to its first pixel "
      "on "
      "offer, in an idle unit, one lane. For the adaptive methods normals turn by 10 degrees along "
      "a span, "
      "tolerance 0.5 LSB, n = 32.");
  page->Figure({SpanPlot(r, 1), SpanPlot(r, 4)}, "RTL cycles per span over its length.", r.command);
  page->Markup(SpanTable(r).Html());
}

constexpr const char* kAutoText =
    "The fewest RTL cycles of another method, one for the whole scene: of those that are sure to "
    "stay within the tolerance on every triangle before they shade, as auto is, and, in "
    "hindsight, of those whose largest error turned out to be at most the tolerance + 0.92 LSB, "
    "0.42 for arithmetic and 0.5 for the rounding of the code.";

void AddAuto(const Results& r, Page* page) {
  if (!r.Has(Method::kAuto) || !r.Has(Method::kPhong)) return;
  page->Section("auto beside the best other method");
  page->Text(kAutoText);
  page->Markup(AutoTable(r).Html());
}

void AddPictures(const Gallery& gallery, Page* page) {
  page->Section("Pictures and error maps");
  page->Text(gallery.title +
             " Left the picture, right the largest error of the pixel's channels against exact "
             "Blinn-Phong: black 0, red 4, yellow 8, white 16 LSB and more.");
  std::string html = "<div class=\"gallery\">";
  for (const ShownPicture& shown : gallery.pictures) {
    html += fmt::format("<figure>{}{}<figcaption>{}: max {}, RMS {} LSB</figcaption></figure>\n",
                        report::PngImage(shown.picture, shown.label + ", picture"),
                        report::PngImage(shown.error_map, shown.label + ", errors"),
                        report::EscapeHtml(shown.label), Significant(shown.error.max_lsb),
                        Significant(shown.error.rms_lsb));
  }
  page->Markup(html + "</div>\n");
  page->Command(gallery.command);
}

void AddClaims(const std::vector<report::Claim>& claims, Page* page) {
  page->Section("What the papers claim");
  page->Text("Ratios are geometric means over the scenes and n of this run, one lane.");
  page->Markup(report::ClaimTable(claims).Html());
}

void AddOperations(const Results& r, Page* page) {
  page->Section("Operations");
  page->Text(
      "x products, + additions and subtractions, sh shifts, tab look-ups in tables, counted in the "
      "bit-exact models. The papers' cost model: a product 8 cycles, everything else 1. Shifts "
      "that "
      "only align formats, rounding, comparisons and clamps are free; triangle set-up, the walk of "
      "the "
      "edges and depth are the same for all methods and left out.");
  page->Markup(OperationTable(r).Html());
}

void AddArea(const Results& r, Page* page) {
  page->Section("Area and longest path");
  if (!r.synthesis) {
    page->Text(r.synthesis_note + ".");
    page->Command("scripts/synth.sh --json build/synth.json");
    return;
  }
  page->Text(
      fmt::format("{}, {}. One number for cells: LUT4 + flip-flops + 2 a carry cell + {} an 18x18 "
                  "multiplier, which is "
                  "what one takes when it is built of LUT4 and carry cells. The longest path is "
                  "from register to "
                  "register in levels of LUT4, without carry chains.",
                  r.synthesis->tool, r.synthesis->target, r.synthesis->multiplier_lut4));
  page->Subsection("Whole shading units with one method");
  page->Markup(AreaTable(r, *r.synthesis).Html());
  page->Subsection("Units");
  page->Markup(UnitTable(*r.synthesis).Html());
  page->Command("scripts/synth.sh --json build/synth.json");
}

}  // namespace

std::string BenchPage(const Results& r, const std::vector<report::Claim>& claims,
                      const Gallery& gallery) {
  Page page(
      "Run time against error",
      {fmt::format(
           "shadesim {}, {} x {} pixels a scene, RTL = model on every pixel and cycle of this run",
           r.version, r.width, r.height),
       r.machine, r.command});
  AddFronts(r, &page);
  AddPlots(r, &page);
  AddSpans(r, &page);
  AddAuto(r, &page);
  AddPictures(gallery, &page);
  AddClaims(claims, &page);
  AddOperations(r, &page);
  AddArea(r, &page);
  page.Section("All measurements");
  page.Text(
      "RTL simulation with four lanes runs the build with all methods, and is slower for that.");
  page.Markup(CellTable(r).Html());
  return page.Html();
}

std::string BenchMarkdown(const Results& r, const std::vector<report::Claim>& claims) {
  const std::string& scene = r.scenes.back();
  const int n = r.shininess[r.shininess.size() / 2];
  std::string text =
      fmt::format("Made by `{}`, shadesim {}, on {}.\n", r.command, r.version, r.machine);
  const auto add = [&](const std::string& heading, const std::string& words,
                       const report::Table& table) {
    text += fmt::format("\n## {}\n\n{}\n\n{}", heading, words, table.Markdown());
  };
  add("Run time against error",
      "On the front by RMS error against exact Blinn-Phong:", FrontTable(r, ErrorKind::kRms));
  add("Cycles per span",
      "Spans of one length back to back, always ready, in steady state; latency of an idle unit, "
      "one lane. Normals turn by 10 degrees along a span; adaptive methods: tolerance 0.5 LSB, n = "
      "32.",
      SpanTable(r));
  add(fmt::format("Cycles, {}", scene),
      fmt::format("{} x {} pixels, n = {}.", r.width, r.height, n), CycleTable(r, scene, n));
  add(fmt::format("Errors and time in software, {}", scene),
      fmt::format("{} x {} pixels, n = {}, one lane; LSB = 1/255, rounding of the code included.",
                  r.width, r.height, n),
      ErrorTable(r, scene, n));
  if (r.Has(Method::kAuto) && r.Has(Method::kPhong)) add("auto", kAutoText, AutoTable(r));
  add("Operations", "Cycles are the papers': a product 8, an addition, a shift or a look-up 1.",
      OperationTable(r));
  if (r.synthesis) {
    add("Synthesis, units", r.synthesis->tool + ", " + r.synthesis->target + ".",
        UnitTable(*r.synthesis));
    add("Synthesis, whole units", "One method each.", AreaTable(r, *r.synthesis));
  }
  add("What the papers claim", "Ratios are geometric means over scenes and n, one lane.",
      report::ClaimTable(claims));
  return text;
}

}  // namespace shading::sim
