// SPDX-License-Identifier: Apache-2.0
//
// Table 1 of paper 003: what is counted is what the page docs/second_order.md says, and differs
// from the paper where it says so. The rows that are counted are rows of the surface.
#include "tests/accuracy/quad_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <random>

#include "sim/stress/quad_drift.h"
#include "sim/stress/quad_rows.h"

namespace shading::accuracy {
namespace {

using Row = std::vector<int64_t>;

std::map<std::string, CostRow> RowsByForm() {
  std::map<std::string, CostRow> rows;
  for (const CostRow& row : CostRows()) rows[row.form] = row;
  return rows;
}

TEST(QuadTable, PaperTotalsFollowFromItsCounts) {
  std::vector<int> totals;
  for (const CostRow& row : CostRows()) {
    if (row.printed) totals.push_back(Cycles(row.paper));
  }
  EXPECT_EQ(totals, (std::vector<int>{1360, 720, 240, 114, 127, 296, 140}));
}

TEST(QuadTable, OnlyThePolynomialIsCountedOtherwise) {
  for (const CostRow& row : CostRows()) {
    if (!row.printed) continue;
    SCOPED_TRACE(row.form);
    EXPECT_EQ(row.counted.additions, row.paper.additions);
    EXPECT_EQ(row.counted.one_bit_shifts, row.paper.one_bit_shifts);
    const int fewer = row.paper.multiplications - row.counted.multiplications;
    EXPECT_EQ(fewer, row.form == "(2)" ? 2 * kPaperPixels : 0);
  }
}

TEST(QuadTable, DifferencesAreAsExplained) {
  auto rows = RowsByForm();
  EXPECT_EQ(rows.at("(2)").counted.multiplications, 8 * kPaperPixels);
  EXPECT_EQ(Cycles(rows.at("(2)").counted), 1104);
  EXPECT_EQ(CyclesOfBarrelShifts(rows.at("(7)").counted), 114);
  EXPECT_EQ(CyclesOfBarrelShifts(rows.at("(7), 4A kept").counted), 102);
  EXPECT_EQ(Cycles(rows.at("(8) as 3 (I2 - I1) + I0").counted), 114);
  EXPECT_EQ(Cycles(rows.at("(5), 2A kept").counted), 101);
  EXPECT_EQ(Cycles(rows.at("two registers").counted), 87);
  EXPECT_EQ(Cycles(rows.at("two registers, Ax and Cy + D shared").counted), 77);
  // 5 products of (9) and 2 an end; 5k + 1 shifts an end and k for the slope of its line.
  for (const int k : {2, 4}) {
    const int ends = kPaperPixels >> k;
    const std::string form = "segments of " + std::to_string(1 << k);
    const Operations printed = rows.at(form + ", as printed").counted;
    EXPECT_EQ(printed.multiplications, 5 + 2 * ends);
    EXPECT_EQ(printed.additions, 5 + 4 * ends + ends * (1 << k));
    EXPECT_EQ(printed.one_bit_shifts, ends * (6 * k + 1));
    const Operations kept = rows.at(form + ", slope kept").counted;
    EXPECT_EQ(kept.multiplications, 5);
    EXPECT_EQ(kept.additions, 5 + 4 + (kPaperPixels - 1) + (ends - 1));
    EXPECT_EQ(kept.one_bit_shifts, 2 * k + 1);
  }
}

TEST(QuadTable, UnitsHaveNoProductButInTheirFormsOfEveryPixel) {
  for (const UnitRow& row : UnitRows()) {
    SCOPED_TRACE(row.unit);
    const int products = row.unit == "quad_polynomial" ? 8
                         : row.unit == "quad_horner"   ? 5
                         : row.unit == "quad_step"     ? 1
                                                       : 0;
    EXPECT_EQ(row.pixels.multiplications, products * kUnitPixels);
    EXPECT_EQ(row.load.multiplications, 0);
  }
}

TEST(QuadTable, PageHasTheTables) {
  std::ifstream file(std::string(SHADESIM_ROOT) + "/docs/second_order.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(page.empty());
  for (const auto& table : {CostTable(), UnitTable(), DriftTable()}) {
    for (const std::string& line : table) {
      EXPECT_NE(page.find(line + "\n"), std::string::npos) << "not on the page: " << line;
    }
  }
}

TEST(QuadRows, EveryFormIsTheSurface) {
  constexpr int n = 64;
  std::mt19937 random(1);
  const auto any = [&] { return static_cast<int64_t>(random() % 2001) - 1000; };
  for (int i = 0; i < 1000; ++i) {
    const RowPoint<int64_t> p = {any(), any(), any(), any(), any(), any(), any(), any()};
    Row surface;
    for (int64_t x = p.x; x < p.x + n; ++x) {
      surface.push_back(p.a * x * x + p.b * p.y * p.y + p.c * x * p.y + p.d * x + p.e * p.y + p.f);
    }
    const RowStart<int64_t> start = StartOf(p);
    const int64_t difference = start.row + start.ax + p.a;
    const Row two(surface.begin(), surface.begin() + 2),
        three(surface.begin(), surface.begin() + 3);
    ASSERT_EQ(start.value, surface[0]);
    ASSERT_EQ(NextByTwo(surface[0], surface[1], p.a), surface[2]);
    ASSERT_EQ(StepRow(start.value, p.a, start.cy, p.d, p.x, n), surface);
    ASSERT_EQ(TwoRow(two, p.a, n), surface);
    ASSERT_EQ(TwoRowKept(two, 2 * p.a, n), surface);
    ASSERT_EQ(ThreeTermRow(three, p.a, n), surface);
    ASSERT_EQ(ThreeTermRowKept(three, 4 * p.a, n), surface);
    ASSERT_EQ(ThirdRowProducts(three, n), surface);
    ASSERT_EQ(ThirdRowShifts(three, n), surface);
    ASSERT_EQ(ThirdRowRise(three, n), surface);
    ASSERT_EQ(DifferenceRow(start.value, difference, 2 * p.a, n), surface);
    for (const int k : {0, 2, 4}) {
      const Row segments = SegmentRow(p, start.value, k, n);
      for (size_t x = 0; x < n; x += size_t{1} << k) ASSERT_EQ(segments[x], surface[x]) << k;
    }
  }
}

TEST(QuadDrift, StaysWithinItsBoundAndNearlyAttainsIt) {
  for (const DriftForm& form : DriftForms()) {
    for (const int bits : kDriftBits) {
      for (const int t : kDriftPixels) {
        const double bound = DriftBound(form, bits, t), worst = WorstDrift(form, bits, t);
        EXPECT_LE(worst, bound) << form.name << " F = " << bits << " t = " << t;
        EXPECT_GT(worst, 0.99 * bound) << form.name << " F = " << bits << " t = " << t;
      }
    }
  }
}

TEST(QuadDrift, GrowthHasAColumnForEveryFormAndItsBound) {
  const std::vector<std::string> lines = DriftGrowth();
  ASSERT_GT(lines.size(), 10u);
  EXPECT_EQ(lines[0][0], '#');
  for (size_t i = 1; i < lines.size(); ++i) {
    EXPECT_EQ(std::count(lines[i].begin(), lines[i].end(), ' '),
              2 * static_cast<int>(DriftForms().size()));
  }
}

}  // namespace
}  // namespace shading::accuracy
