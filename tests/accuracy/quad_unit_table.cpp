// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "model/intensity/quad_difference.h"
#include "model/intensity/quad_horner.h"
#include "model/intensity/quad_midpoint.h"
#include "model/intensity/quad_polynomial.h"
#include "model/intensity/quad_segment.h"
#include "model/intensity/quad_step.h"
#include "model/intensity/quad_surface.h"
#include "model/intensity/quad_third_difference.h"
#include "model/intensity/quad_three_term.h"
#include "sim/stress/quad_rows.h"
#include "tests/accuracy/quad_table.h"

namespace shading::accuracy {
namespace {

template <typename Unit, typename... Inputs>
UnitRow UnitRowOf(std::string name, std::string equation, const Inputs&... inputs) {
  const Operations before = CountedWord::Total();
  Unit unit(inputs...);
  const Operations loaded = CountedWord::Total();
  for (int i = 0; i < kUnitPixels; ++i, unit.Step()) unit.code();
  return {std::move(name), std::move(equation), loaded - before, CountedWord::Total() - loaded};
}

std::string PerPixel(int operations) {
  return operations % kUnitPixels == 0
             ? fmt::format("{}", operations / kUnitPixels)
             : fmt::format("{:.4g}", static_cast<double>(operations) / kUnitPixels);
}

}  // namespace

std::vector<UnitRow> UnitRows() {
  using Word = CountedWord;
  const SurfacePoint point;
  const ChannelSeed seed;
  return {
      UnitRowOf<BasicQuadPolynomial<Word>>("quad_polynomial", "(2)", point),
      UnitRowOf<BasicQuadHorner<Word>>("quad_horner", "(9)", point),
      UnitRowOf<BasicQuadStep<Word>>("quad_step", "(3)", seed),
      UnitRowOf<BasicQuadSurface<Word>>("quad_surface", "(5)", seed),
      UnitRowOf<BasicQuadMidpoint<Word>>("quad_midpoint", "(5), (6)", seed),
      UnitRowOf<BasicQuadThreeTerm<Word>>("quad_three_term", "(7)", seed),
      UnitRowOf<BasicQuadThirdDifference<Word>>("quad_third_difference", "(8)", seed),
      UnitRowOf<BasicQuadDifference<Word>>("quad_difference", "I += d, d += 2A", seed),
      UnitRowOf<BasicQuadSegment<Word>>("quad_segment", "segments of 4", kBent, ToleranceFor(2)),
  };
}

std::vector<std::string> UnitTable() {
  std::vector<std::string> lines = {"| unit | form | x | + | shift | load: + | shift |",
                                    "|---|---|--:|--:|--:|--:|--:|"};
  for (const UnitRow& row : UnitRows()) {
    lines.push_back(fmt::format("| {} | {} | {} | {} | {} | {} | {} |", row.unit, row.equation,
                                PerPixel(row.pixels.multiplications),
                                PerPixel(row.pixels.additions), PerPixel(row.pixels.shifts),
                                row.load.additions, row.load.shifts));
  }
  return lines;
}

}  // namespace shading::accuracy
