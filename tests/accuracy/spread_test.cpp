// SPDX-License-Identifier: Apache-2.0
//
// What docs/second_order.md says of the surface methods against exact Blinn-Phong, by a smaller
// search.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>

#include "model/shading_unit.h"
#include "tests/accuracy/spread_table.h"

namespace shading::accuracy {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kUnitBound = 0.5 + ShadingUnit::kContract.max_error_ulp;

const SpreadCells& QuickCells() {
  static const SpreadCells cells = SearchCells(kQuickSearch);
  return cells;
}

// Two digits are all that some expected values have.
double Slack(double expected) {
  const double last_digit = std::pow(10, std::floor(std::log10(expected)) - 1);
  return std::max(0.03 * expected, 0.55 * last_digit);
}

// The cells of a row; a range is two.
std::vector<std::string> Cells(std::string line) {
  for (size_t at; (at = line.find(" - ")) != std::string::npos;) line.replace(at, 3, " | ");
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, '|');) cells.push_back(cell);
  return cells;
}

// Numbers may differ by as much as the smaller search misses.
bool SameLine(const std::string& a, const std::string& b) {
  const auto left = Cells(a), right = Cells(b);
  return std::equal(left.begin(), left.end(), right.begin(), right.end(),
                    [](const std::string& x, const std::string& y) {
                      if (x == y) return true;
                      const double u = std::atof(x.c_str()), v = std::atof(y.c_str());
                      return u > 0 && std::abs(u - v) <= 0.02 * v;
                    });
}

// The surface at 128 sees a triangle of 13 degrees well, by the search and in the displayed codes.
TEST(Spread, HighlightOf128WithinOneCodeAt13DegreesByQuadCosine) {
  const SpreadLight light = FullLight(128);
  const SpreadWorst worst = SpreadSearch(Method::kQuadCosine, light, 13).Run(kFullSearch);
  EXPECT_LE(worst.error, 1);
  EXPECT_GT(worst.error, 0.85) << "the search is blind";
  const ProductErrors product = ProductErrorsOf(Method::kQuadCosine, light, worst.at);
  EXPECT_LE(product.closed_form, 1);
  EXPECT_LE(product.codes, 1 + kUnitBound);
  EXPECT_GT(SearchedError(Method::kQuad, light, 13, kQuickSearch), 40) << "why quad will not do";
}

TEST(Spread, LimitsAreAsExpected) {
  for (const Method method : kSpreadMethods) {
    for (const int n : kSpreadShininess) {
      for (const double codes : kLimitCodes) {
        const double expected = ExpectedLimit(method, n, codes);
        ASSERT_GT(expected, 0);
        EXPECT_NEAR(SearchedLimit(method, FullLight(n), codes, kQuickSearch), expected,
                    Slack(expected))
            << Name(method) << " n " << n << " codes " << codes;
      }
    }
  }
}

// Through the product, too: the closed forms reach the searched errors, the codes follow them.
TEST(Spread, ErrorsAreAsExpectedAndThoseOfTheProduct) {
  for (const SpreadCell& cell : QuickCells().lit) {
    SCOPED_TRACE(testing::Message()
                 << Name(cell.method) << " n " << cell.light.shininess << " at " << cell.degrees);
    const double expected = ExpectedError(cell.method, cell.light.shininess, cell.degrees);
    if (expected > 0) {
      EXPECT_NEAR(cell.worst.error, std::min(expected, 255.0), std::max(Slack(expected), 5e-4));
    }
    EXPECT_GT(cell.product.pixels, 15000);
    EXPECT_LE(cell.product.closed_form, cell.worst.error * 1.03 + 1e-3);
    EXPECT_GE(cell.product.closed_form, cell.worst.error * 0.95 - 1e-3);
    EXPECT_LE(cell.product.unit, kUnitBound);
    EXPECT_NEAR(cell.product.codes, cell.product.closed_form, kUnitBound);
  }
}

TEST(Spread, TerminatorBreaksQuadNotTheMethodsThatClampPerPixel) {
  for (const double degrees : kTerminatorSpreads) {
    const SpreadLight light = FullLight(1, false);
    const SpreadWorst quad = SpreadSearch(Method::kQuad, light, degrees).Run(kQuickSearch);
    EXPECT_GE(quad.error, 0.97 * ExpectedTerminator(Method::kQuad, degrees)) << degrees;
    EXPECT_LE(ProductErrorsOf(Method::kQuad, light, quad.at).unit, kUnitBound);
    const double lit = SearchedError(Method::kQuad, FullLight(1), degrees, kQuickSearch);
    for (const Method method : {Method::kQuadSplit, Method::kQuadCosine}) {
      EXPECT_LE(SearchedError(method, light, degrees, kQuickSearch), 1.05 * lit)
          << Name(method) << " at " << degrees;
    }
  }
}

std::string Page() {
  std::ifstream file(std::string(SHADESIM_ROOT) + "/docs/second_order.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

void ExpectOnPage(const std::vector<std::string>& table) {
  std::istringstream text(Page());
  std::vector<std::string> page;
  for (std::string line; std::getline(text, line);) page.push_back(line);
  ASSERT_FALSE(page.empty());
  for (const std::string& line : table) {
    EXPECT_TRUE(std::any_of(page.begin(), page.end(),
                            [&](const std::string& there) { return SameLine(line, there); }))
        << "not on the page: " << line;
  }
}

TEST(Spread, PageHasTheTables) {
  for (const int n : kSpreadShininess) ExpectOnPage(ErrorTable(QuickCells(), n));
  ExpectOnPage(TerminatorTable(QuickCells()));
  ExpectOnPage(ProductTable(QuickCells()));
  ExpectOnPage(LimitTable(kQuickSearch));
}

// 640 limits: a still smaller search.
TEST(Spread, PageHasTheTurnLimits) { ExpectOnPage(TurnLimitTable({10, 20, 300})); }

TEST(Spread, PageHasTheSummary) {
  std::string page = Page();
  std::replace(page.begin(), page.end(), '\n', ' ');
  const SpreadSummary summary = SummaryOf(QuickCells());
  char sentence[160];
  std::snprintf(sentence, sizeof(sentence),
                "In all %d cells, with %.1f million pixels, the displayed codes are within %.3f of "
                "the method's closed form",
                static_cast<int>(summary.cells), 1e-6 * static_cast<double>(summary.pixels),
                summary.unit);
  EXPECT_NE(page.find(sentence), std::string::npos) << sentence;
  std::smatch below;
  ASSERT_TRUE(std::regex_search(page, below, std::regex("at most ([0-9.]+) % below it")));
  EXPECT_NEAR(100 * summary.short_of, std::stod(below[1]), 0.2);
  EXPECT_LT(summary.above, 0.005);
}

// The case of one edge, by hand: two normals psi apart, H over the first, the point in the middle
// of the edge. The quadratic is exact there, the line is off by half the fall beyond the middle's.
TEST(Spread, ErrorOfAnEdgeIsItsClosedForm) {
  const double psi = 0.2;
  SpreadCase at;
  at.normal = {ideal::Vector{0, 0, 1}, {std::sin(psi), 0, std::cos(psi)}, {0, 0, 1}};
  at.light = at.half = {0, 0, 1};
  at.weight = {0.5, 0.5, 0};
  const SpreadLight light = FullLight(32);
  const auto lit = [](double angle) { return 255 * std::pow(std::cos(angle), 32); };
  EXPECT_NEAR(SpreadError(Method::kGouraud, light, at), lit(psi / 2) - (lit(0) + lit(psi)) / 2,
              1e-9);
  for (const Method method : {Method::kQuad, Method::kQuadSplit, Method::kQuadCosine}) {
    EXPECT_NEAR(SpreadError(method, light, at), 0, 1e-9) << Name(method);
  }
  // At a quarter the cosines 1, cos(psi/2), cos(psi) have the shape functions 3/8, 3/4, -1/8.
  at.weight = {0.75, 0.25, 0};
  const double cosine = 0.375 + 0.75 * std::cos(psi / 2) - 0.125 * std::cos(psi);
  EXPECT_NEAR(CodesOf(Method::kQuadCosine, light, at).shown, 255 * std::pow(cosine, 32), 1e-9);
  EXPECT_NEAR(CodesOf(Method::kQuad, light, at).shown,
              0.375 * lit(0) + 0.75 * lit(psi / 2) - 0.125 * lit(psi), 1e-9);
  const double exact = std::atan2(0.25 * std::sin(psi), 0.75 + 0.25 * std::cos(psi));
  EXPECT_NEAR(CodesOf(Method::kQuad, light, at).exact, lit(exact), 1e-9);
}

// No worse triangle than the equilateral one: the corners of the worst case are all as far apart.
TEST(Spread, WorstTriangleIsEquilateral) {
  for (const Method method : {Method::kGouraud, Method::kQuad, Method::kQuadCosine}) {
    for (const int n : kSpreadShininess) {
      const SpreadCase at = SpreadSearch(method, FullLight(n), 10).Run(kQuickSearch).at;
      for (size_t i = 0; i < 3; ++i) {
        const double cosine = ideal::Dot(at.normal[i], at.normal[(i + 1) % 3]);
        EXPECT_NEAR(std::acos(std::min(cosine, 1.0)) * 180 / kPi, 10, 0.05)
            << Name(method) << " n " << n;
      }
    }
  }
}

}  // namespace
}  // namespace shading::accuracy
