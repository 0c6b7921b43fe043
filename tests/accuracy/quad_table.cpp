// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/quad_table.h"

#include <fmt/format.h>

#include <array>

#include "model/intensity/quad_difference.h"
#include "model/intensity/quad_horner.h"
#include "model/intensity/quad_midpoint.h"
#include "model/intensity/quad_polynomial.h"
#include "model/intensity/quad_segment.h"
#include "model/intensity/quad_step.h"
#include "model/intensity/quad_surface.h"
#include "model/intensity/quad_third_difference.h"
#include "model/intensity/quad_three_term.h"
#include "tests/accuracy/quad_rows.h"

namespace shading::accuracy {
namespace {

// 2A = 1/32 code, and the tolerance that segments of 2^k pixels attain: 2A 4^k / 8.
constexpr int kBend = IntensityAcc::kFraction - 5;
const ChannelSeed kBent = {{}, {}, {}, IntensityAcc::FromRaw(int64_t{1} << kBend)};
Tolerance ToleranceFor(int k) { return Tolerance::FromRaw(int64_t{16} << (2 * k)); }

template <typename Function>
Operations CountOf(const Function& function) {
  const Operations before = CountedWord::Total();
  function();
  return CountedWord::Total() - before;
}

// Operations do not depend on the numbers.
RowPoint<CountedWord> AnyPoint() {
  const auto number = [](int64_t n) { return Number<CountedWord>(n); };
  return {number(3), number(-5), number(7), number(11), number(-13), number(17), 37, 19};
}

// The row's first pixels as the paper starts its recurrences: (9), (3), (5).
struct Starts {
  explicit Starts(int pixels) {
    const RowStart<CountedWord> start = StartOf(point);
    row.push_back(start.value);
    row.push_back(NextByStep(start.value, point.a, start.cy, point.d, point.x));
    if (pixels > 2) row.push_back(NextByTwo(row[0], row[1], point.a));
  }
  RowPoint<CountedWord> point = AnyPoint();
  std::vector<CountedWord> row;
};

template <typename Rest>
Operations Recurrence(int start_pixels, const Rest& rest) {
  return CountOf([&] {
    const Starts starts(start_pixels);
    rest(starts.row, starts.point.a);
  });
}

// A unit that evaluates every pixel from the coefficients.
template <template <typename> class Unit>
Operations EveryPixel() {
  return CountOf([] {
    Unit<CountedWord> unit(SurfacePoint{});
    for (int i = 0; i < kPaperPixels; ++i, unit.Step()) unit.code();
  });
}

Operations Steps() {
  return CountOf([] {
    const RowPoint<CountedWord> p = AnyPoint();
    const RowStart<CountedWord> start = StartOf(p);
    StepRow(start.value, p.a, start.cy, p.d, p.x, kPaperPixels);
  });
}

Operations Differences(bool shared) {
  return CountOf([&] {
    const RowPoint<CountedWord> p = AnyPoint();
    const RowStart<CountedWord> start = StartOf(p);
    const CountedWord difference =
        shared ? start.row + start.ax + p.a
               : ((p.a * Number<CountedWord>(p.x)) << 1) + p.a + start.cy + p.d;
    DifferenceRow(start.value, difference, p.a << 1, kPaperPixels);
  });
}

Operations Segments(int k) {
  return CountOf([&] {
    const RowPoint<CountedWord> p = AnyPoint();
    SegmentRow(p, StartOf(p).value, k, kPaperPixels);
  });
}

// The unit with segments of 2^k pixels: start of the row as span_setup forms it, then the model.
Operations SegmentUnit(int k) {
  return CountOf([&] {
    const RowPoint<CountedWord> p = AnyPoint();
    const RowStart<CountedWord> start = StartOf(p);
    [[maybe_unused]] const CountedWord difference = start.row + start.ax + p.a;
    [[maybe_unused]] const CountedWord two_a = p.a << 1;
    BasicQuadSegment<CountedWord> unit(kBent, ToleranceFor(k));
    for (int i = 1; i < kPaperPixels; ++i) unit.Step();
  });
}

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

std::vector<CostRow> CostRows() {
  constexpr int n = kPaperPixels;
  using Row = std::vector<CountedWord>;
  using Word = CountedWord;
  return {
      {"(2)",
       true,
       {160, 80, 0, 0},
       EveryPixel<BasicQuadPolynomial>(),
       "A x x, B y y, C x y are two products each, D x and E y one: 8, the paper counts 10"},
      {"(9)", true, {80, 80, 0, 0}, EveryPixel<BasicQuadHorner>(), "equal"},
      {"(3)", true, {20, 65, 15, 15}, Steps(), "equal"},
      {"(5)",
       true,
       {6, 37, 29, 29},
       Recurrence(2, [](const Row& row, const Word& a) { TwoRow(row, a, n); }),
       "equal"},
      {"(5), 2A kept",
       false,
       {},
       Recurrence(2, [](const Row& row, const Word& a) { TwoRowKept(row, a << 1, n); }),
       "2A is the same for the whole triangle"},
      {"(7)",
       true,
       {6, 50, 29, 29},
       Recurrence(3, [](const Row& row, const Word& a) { ThreeTermRow(row, a, n); }),
       "equal: 4A is two shifts by one bit, as in the paper's 5k + 1; 114 if it is one shift"},
      {"(7), 4A kept",
       false,
       {},
       Recurrence(3, [](const Row& row, const Word& a) { ThreeTermRowKept(row, a << 2, n); }),
       "4A is the same for the whole triangle"},
      {"(8)",
       true,
       {32, 37, 3, 3},
       Recurrence(3, [](const Row& row, const Word&) { ThirdRowProducts(row, n); }),
       "equal"},
      {"(8), optimised",
       true,
       {6, 63, 29, 29},
       Recurrence(3, [](const Row& row, const Word&) { ThirdRowShifts(row, n); }),
       "equal"},
      {"(8) as 3 (I2 - I1) + I0",
       false,
       {},
       Recurrence(3, [](const Row& row, const Word&) { ThirdRowRise(row, n); }),
       "one product by 3 instead of two"},
      {"two registers",
       false,
       {},
       Differences(false),
       "I += d, d += 2A: the product and the sum of (3) only at the start"},
      {"two registers, Ax and Cy + D shared",
       false,
       {},
       Differences(true),
       "the start's d from the terms that (9) has formed"},
      {"segments of 4, as printed",
       false,
       {},
       Segments(2),
       "2 products, 4 additions, 5k + 1 shifts an end; slope of the line by 1 and k"},
      {"segments of 16, as printed", false, {}, Segments(4), "the whole row is one line"},
      {"segments of 4, slope kept",
       false,
       {},
       SegmentUnit(2),
       "slope += 2^k 2A: an addition a pixel, and one a segment"},
      {"segments of 16, slope kept", false, {}, SegmentUnit(4), "the whole row is one line"},
  };
}

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

std::vector<std::string> CostTable() {
  std::vector<std::string> lines = {
      "| form | paper: x | + | shift | cycles | counted: x | + | shift | cycles | shift by n: 1 | "
      "why |",
      "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|"};
  for (const CostRow& row : CostRows()) {
    const std::string paper =
        row.printed ? fmt::format("{} | {} | {} | {}", 8 * row.paper.multiplications,
                                  row.paper.additions, row.paper.one_bit_shifts, Cycles(row.paper))
                    : "| | |";
    const Operations& done = row.counted;
    lines.push_back(fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} |", row.form, paper,
                                8 * done.multiplications, done.additions, done.one_bit_shifts,
                                Cycles(done), CyclesOfBarrelShifts(done), row.why));
  }
  return lines;
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
