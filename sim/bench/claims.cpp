// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/report/html.h"

namespace shading::sim {
namespace {

using report::Claim;
using report::Significant;
using report::Verdict;

double Software(const Cell& cell) { return cell.SoftwareNanoseconds(); }
double Model(const Cell& cell) { return cell.model_seconds; }
double Processor(const Cell& cell) { return cell.PaperCyclesPerPixel(); }
double Rtl(const Cell& cell) { return cell.CyclesPerPixel(); }
double RmsError(const Cell& cell) { return cell.phong.rms_lsb; }

// How many times as fast, by each way to take the time; empty when the run has not both methods.
std::string Times(const Results& r, Method slow, Method fast) {
  const auto model = MeanRatio(r, slow, fast, Model);
  if (!model) return "";
  return fmt::format(
      "{} times as fast in the model, {} with the front end; {} in the papers' cycles, {} in RTL "
      "cycles",
      Significant(*model), Significant(*MeanRatio(r, slow, fast, Software)),
      Significant(*MeanRatio(r, slow, fast, Processor)),
      Significant(*MeanRatio(r, slow, fast, Rtl)));
}

std::string Parts(const Operations& o) {
  return fmt::format("{:g} products, {:g} additions, {:g} shifts", o.multiplications, o.additions,
                     o.shifts);
}

// The claim with what was measured, or as not measured where that is empty.
Claim Measured(Claim claim, const std::string& measured, Verdict verdict) {
  claim.measured = measured.empty() ? "the methods are not in this run" : measured;
  claim.verdict = measured.empty() ? Verdict::kNotMeasured : verdict;
  return claim;
}

// Holds when a quantity of `slow` is at least `factor` times that of `fast`.
Verdict AtLeast(const std::optional<double>& ratio, double factor) {
  return ratio && *ratio >= factor ? Verdict::kHolds : Verdict::kFails;
}

Claim OperationsOfANormal() {
  const Operations normal = CostOf(Method::kSlerpPaper).pixel + -1.0 * VectorLight();
  const bool so = normal.multiplications <= 3 && normal.additions <= 3 && normal.shifts <= 3;
  return {"000, end", "a normal takes 3 products, 3 shifts and 3 subtractions",
          "slerp-paper, the normal of a pixel: " + Parts(normal) + "; 2 cos(phi) is one factor",
          so ? Verdict::kHolds : Verdict::kFails, "docs/units/normal/slerp_paper.md"};
}

Claim TwiceAsFast(const Results& r) {
  return Measured({"000, end", "more than 2 times faster than classic Phong", "", Verdict::kFails,
                   "docs/results.md"},
                  Times(r, Method::kPhong, Method::kSlerpPaper),
                  AtLeast(MeanRatio(r, Method::kPhong, Method::kSlerpPaper, Model), 2));
}

Claim DirectSines(const Results& r) {
  return Measured({"000 (7)", "the recurrence replaces the sines of every pixel, much faster", "",
                   Verdict::kHolds, "docs/units/normal/slerp_direct.md"},
                  Times(r, Method::kSlerpDirect, Method::kSlerpPaper),
                  AtLeast(MeanRatio(r, Method::kSlerpDirect, Method::kSlerpPaper, Model), 1.2));
}

Claim ScalarRecurrence(const Results& r) {
  return Measured(
      {"000 (14)", "N.L and N.H by one product, subtraction and shift each simplify the light", "",
       Verdict::kHolds, "docs/units/normal/slerp_recurrence.md"},
      Times(r, Method::kSlerpPaper, Method::kSlerpIntensity),
      AtLeast(MeanRatio(r, Method::kSlerpPaper, Method::kSlerpIntensity, Model), 1));
}

Claim FourAtOnce(const Results& r) {
  const SpanCurve *one = r.Curve(Method::kSlerpPaper, 1), *four = r.Curve(Method::kSlerpPaper, 4);
  std::string measured;
  if (one != nullptr && four != nullptr) {
    measured = fmt::format(
        "a span of 256 pixels takes {} cycles with one lane, {} with four; (10) and "
        "(11) are wrong as printed and work corrected",
        Significant(one->CyclesOf(256)), Significant(four->CyclesOf(256)));
  }
  return Measured({"000 (9) to (11)", "four normals at once from the same operands", "",
                   Verdict::kHoldsInPart, "docs/units/normal/slerp_paper.md"},
                  measured, Verdict::kHoldsInPart);
}

Claim Taylor(const Results& r) {
  const auto taylor = Largest(r, Method::kPhongTaylor, RmsError),
             phong = Largest(r, Method::kPhong, RmsError);
  std::string measured;
  if (taylor && phong) {
    measured = fmt::format(
        "largest RMS error of a picture: phong-taylor {} LSB, phong {} LSB; it fails "
        "with the angle of a span, beyond 22 degrees at n = 128",
        Significant(*taylor), Significant(*phong));
  }
  return Measured({"000, Lyon", "three terms of Taylor's series are not accurate enough", "",
                   Verdict::kHoldsInPart, "docs/accuracy.md"},
                  measured, Verdict::kHoldsInPart);
}

// On scenes of the size that the paper names.
Claim Adaptive(const Results& r) {
  const CellTest middling = [](const Cell& c) { return c.packets >= 300 && c.packets <= 1500; };
  const auto change = [&](const CellNumber& of) {
    const auto ratio = MeanRatio(r, Method::kAdaptive, Method::kPhong, of, middling);
    return fmt::format("{:+.0f} %", 100 * (ratio.value_or(1) - 1));
  };
  Claim claim{"002, end", "20 to 30 % faster on meshes of 300 to 1500 triangles",
              "no scene of 300 to 1500 triangles with both methods in this run",
              Verdict::kNotMeasured, "docs/adaptive.md"};
  const auto rtl = MeanRatio(r, Method::kAdaptive, Method::kPhong, Rtl, middling);
  if (!rtl) return claim;
  claim.measured = fmt::format(
      "adaptive against phong, scenes of 300 to 1500 triangles, least tolerance: RTL cycles {}, "
      "the papers' cycles "
      "{}, time of the model {}",
      change(Rtl), change(Processor), change(Model));
  claim.verdict = *rtl <= 1 / 1.2 ? Verdict::kHolds : Verdict::kFails;
  return claim;
}

Claim SetUp() {
  return {"000, stage 1", "the set-up of a span takes an arccos and a sine",
          "not so: squares of chords and four tables of quadratics, " +
              Parts(CostOf(Method::kSlerp).span) + " a span",
          Verdict::kFails, "docs/units/normal/normal_setup.md"};
}

Claim Footprint() {
  return {
      "001", "averaging over a pixel's footprint gives more exact intensities",
      "against 4096 samples, n = 128, 5 degrees along a footprint of 1:4: 29.5 LSB off with the "
      "centre alone, 1.9 with 2 samples, 0.08 with 4",
      Verdict::kHolds, "docs/footprint.md"};
}

Claim RowClaim(const Results& r, Method slow, Method fast, const char* place, const char* text,
               double factor) {
  const double pixel = PaperCycles(CostOf(slow).pixel) / PaperCycles(CostOf(fast).pixel);
  std::string measured = Times(r, slow, fast);
  if (!measured.empty()) {
    measured +=
        fmt::format("; a pixel alone {} times in the papers' cycles; rows of 16 pixels: see page",
                    Significant(pixel));
  }
  return Measured({place, text, "", Verdict::kHolds, "docs/second_order.md"}, measured,
                  pixel >= factor ? Verdict::kHolds : Verdict::kFails);
}

Claim NoMultiplier(const Results& r) {
  Claim claim{"003, figures 4 and 5", "blocks without a multiplier", "", Verdict::kNotMeasured,
              "docs/second_order.md"};
  claim.measured = "not synthesised in this run";
  if (!r.synthesis) return claim;
  const auto* four = r.synthesis->FindUnit("quad_surface");
  const auto* five = r.synthesis->FindUnit("quad_third_difference");
  if (four == nullptr || five == nullptr) return claim;
  claim.measured = fmt::format(
      "quad_surface {} LUT4, {} multipliers; quad_third_difference {} LUT4, {} multipliers",
      four->cells.lut4, four->cells.multipliers, five->cells.lut4, five->cells.multipliers);
  claim.verdict =
      four->cells.multipliers + five->cells.multipliers == 0 ? Verdict::kHolds : Verdict::kFails;
  return claim;
}

Claim BetterThanGouraud(const Results& r) {
  const auto ratio = MeanRatio(r, Method::kGouraud, Method::kQuad, RmsError);
  std::string measured;
  if (ratio) {
    measured = fmt::format(
        "RMS error of gouraud is {} times that of quad, rounding included; {} times the time in "
        "software",
        Significant(*ratio), Significant(*MeanRatio(r, Method::kQuad, Method::kGouraud, Software)));
  }
  return Measured({"003", "a second-order surface shows highlights that Gouraud's loses", "",
                   Verdict::kHolds, "docs/second_order.md"},
                  measured, AtLeast(ratio, 1.05));
}

Claim CheapestForm(const Results& r) {
  return Measured(
      {"003, table 1", "(5) is the cheapest exact form", "", Verdict::kFails,
       "docs/second_order.md"},
      r.Has(Method::kQuad) && r.Has(Method::kQuadDifference)
          ? fmt::format(
                "two registers, I += d, d += 2A: {:g} operations a pixel and channel, (5): {:g}",
                CostOf(Method::kQuadDifference).pixel.total() / 3,
                CostOf(Method::kQuad).pixel.total() / 3)
          : "",
      Verdict::kFails);
}

}  // namespace

std::vector<Claim> PaperClaims(const Results& r) {
  return {
      OperationsOfANormal(),
      TwiceAsFast(r),
      DirectSines(r),
      ScalarRecurrence(r),
      FourAtOnce(r),
      Taylor(r),
      SetUp(),
      Footprint(),
      Adaptive(r),
      {"002", "a line between unit normals errs by 4 % at 32 degrees, 1 % at 16",
       "3.87 % at 32, 0.97 % at 16", Verdict::kOnPage, "docs/units/normal/adaptive_normalizer.md"},
      RowClaim(r, Method::kQuadPolynomial, Method::kQuadHorner, "003, table 1",
               "(9) is 1.9 times as fast as (2)", 1.85),
      RowClaim(r, Method::kQuadHorner, Method::kQuadStep, "003, end",
               "(3) saves 67 % of the cycles of (9)", 3),
      RowClaim(r, Method::kQuadHorner, Method::kQuad, "003, end",
               "(5) saves 84 % of the cycles of (9)", 6.2),
      CheapestForm(r),
      NoMultiplier(r),
      BetterThanGouraud(r)};
}

}  // namespace shading::sim
