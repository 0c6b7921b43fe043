// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/spread_product.h"
#include "tests/accuracy/spread_search.h"

namespace shading::accuracy {

inline constexpr std::array<double, 9> kSpreads = {2.5, 5, 10, 15, 20, 30, 45, 60, 90};  // degrees
inline constexpr std::array<int, 4> kSpreadShininess = {1, 8, 32, 128};  // 1 stands for diffuse
inline constexpr std::array<Method, 4> kSpreadMethods = {Method::kGouraud, Method::kQuad,
                                                         Method::kQuadSplit, Method::kQuadCosine};
inline constexpr std::array<double, 3> kLimitCodes = {0.5, 1, 2};
inline constexpr std::array<int, 5> kTurnShininess = {1, 8, 32, 128, 256};
inline constexpr std::array<double, 4> kTerminatorSpreads = {5, 10, 30, 90};

// Full-scale light of one kind: kd = 1, or ks = 1. `lit` as in SpreadLight.
SpreadLight FullLight(int shininess, bool lit = true);

// Computed apart from the search in floating point, on a grid of points with random lights; 0 where
// nothing was. The largest error at a spread, the spread of an error, and the error of quad with a
// terminator in the triangle.
double ExpectedError(Method method, int shininess, double degrees);
double ExpectedLimit(Method method, int shininess, double codes);
double ExpectedTerminator(Method method, double degrees);

// One searched cell, and what the product makes of its worst case.
struct SpreadCell {
  Method method = Method::kQuad;
  SpreadLight light;
  double degrees = 0;
  SpreadWorst worst;
  ProductErrors product;
};

// Shininess by shininess, spread by spread, method by method; then the terminators.
struct SpreadCells {
  std::vector<SpreadCell> lit, terminator;
};
SpreadCells SearchCells(const SpreadEffort& effort);

// Markdown, a line a string.
std::vector<std::string> ErrorTable(const SpreadCells& cells, int shininess);
std::vector<std::string> TerminatorTable(const SpreadCells& cells);
std::vector<std::string> LimitTable(const SpreadEffort& effort);
// The angles of TurnLimitDegrees in parts of those that the search finds: the least and the most
// over kd, ks in {0, 1/2, 1} and tolerances of 1/2, 1, 2, 4 codes.
std::vector<std::string> TurnLimitTable(const SpreadEffort& effort);
std::vector<std::string> ProductTable(const SpreadCells& cells);
std::vector<std::string> Summary(const SpreadCells& cells);

// For gnuplot: writes `file`, an SVG of the errors over the spread.
std::string SpreadPlot(const SpreadCells& cells, const std::string& file);

}  // namespace shading::accuracy
