// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace shading::accuracy {

inline constexpr std::array<int, 4> kDriftBits = {16, 20, 24, 26};  // fraction bits of a code
inline constexpr std::array<int, 6> kDriftPixels = {16, 64, 256, 1024, 2047, 4095};
inline constexpr int kFineBits = 16;  // below the last bit to which a start value is rounded

// Start values and coefficients of a form, in units of 2^-(F + kFineBits) codes. The recurrences
// add integers, so whatever a row is off by comes from rounding these to F bits.
using Numbers = std::array<int64_t, 4>;

struct DriftForm {
  std::string name;
  std::string rounded;                                  // which numbers
  std::string bound;                                    // as a formula
  std::function<Numbers(const Numbers& curve)> starts;  // of a real curve: exact
  std::function<void(Numbers* starts)> tie;             // the fourth follows from the other three
  std::function<int64_t(const Numbers& starts, int t)> at;  // pixel t, by running the form
  std::function<double(int t)> half_ulps;                   // the bound, in 2^-(F+1) codes
};
std::vector<DriftForm> DriftForms();

// Largest drift at pixel t in codes, by hill-climbing over curves and their roundings to F bits:
// to nearest, or truncated.
double WorstDrift(const DriftForm& form, int fraction_bits, int t, unsigned seed = 0,
                  bool truncate = false);
double DriftBound(const DriftForm& form, int fraction_bits, int t);

// Markdown, a line a string.
std::vector<std::string> DriftTable();
// For gnuplot: t, and for each form the drift found with 26 fraction bits and its bound, in codes.
std::vector<std::string> DriftGrowth();

}  // namespace shading::accuracy
