// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/quad_table.h"

#include <fmt/format.h>

#include <array>

#include "model/intensity/quad_horner.h"
#include "model/intensity/quad_polynomial.h"
#include "model/intensity/quad_segment.h"
#include "sim/stress/quad_rows.h"

namespace shading::accuracy {
namespace {

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

using Pixels = std::vector<CountedWord>;

// (2), (9) and (3): from the coefficients.
std::vector<CostRow> CoefficientRows() {
  return {
      {"(2)",
       true,
       {160, 80, 0, 0},
       EveryPixel<BasicQuadPolynomial>(),
       "A x x, B y y, C x y are two products each, D x and E y one: 8, the paper counts 10"},
      {"(9)", true, {80, 80, 0, 0}, EveryPixel<BasicQuadHorner>(), "equal"},
      {"(3)", true, {20, 65, 15, 15}, Steps(), "equal"},
  };
}

// (5) and (7): from pixels and A.
std::vector<CostRow> PairRows() {
  return {
      {"(5)",
       true,
       {6, 37, 29, 29},
       Recurrence(2, [](const Pixels& row, const CountedWord& a) { TwoRow(row, a, kPaperPixels); }),
       "equal"},
      {"(5), 2A kept",
       false,
       {},
       Recurrence(2, [](const Pixels& row,
                        const CountedWord& a) { TwoRowKept(row, a << 1, kPaperPixels); }),
       "2A is the same for the whole triangle"},
      {"(7)",
       true,
       {6, 50, 29, 29},
       Recurrence(
           3, [](const Pixels& row, const CountedWord& a) { ThreeTermRow(row, a, kPaperPixels); }),
       "equal: 4A is two shifts by one bit, as in the paper's 5k + 1; 114 if it is one shift"},
      {"(7), 4A kept",
       false,
       {},
       Recurrence(3, [](const Pixels& row,
                        const CountedWord& a) { ThreeTermRowKept(row, a << 2, kPaperPixels); }),
       "4A is the same for the whole triangle"},
  };
}

// (8): from three pixels.
std::vector<CostRow> ThirdDifferenceRows() {
  return {
      {"(8)",
       true,
       {32, 37, 3, 3},
       Recurrence(
           3, [](const Pixels& row, const CountedWord&) { ThirdRowProducts(row, kPaperPixels); }),
       "equal"},
      {"(8), optimised",
       true,
       {6, 63, 29, 29},
       Recurrence(3,
                  [](const Pixels& row, const CountedWord&) { ThirdRowShifts(row, kPaperPixels); }),
       "equal"},
      {"(8) as 3 (I2 - I1) + I0",
       false,
       {},
       Recurrence(3,
                  [](const Pixels& row, const CountedWord&) { ThirdRowRise(row, kPaperPixels); }),
       "one product by 3 instead of two"},
  };
}

// What the paper does not count.
std::vector<CostRow> DifferenceRows() {
  return {
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

}  // namespace

std::vector<CostRow> CostRows() {
  std::vector<CostRow> all;
  for (const auto& rows :
       {CoefficientRows(), PairRows(), ThirdDifferenceRows(), DifferenceRows()}) {
    all.insert(all.end(), rows.begin(), rows.end());
  }
  return all;
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

}  // namespace shading::accuracy
