// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "tests/accuracy/counted_word.h"

namespace shading::accuracy {

inline constexpr int kPaperPixels = 16;  // a row of the paper's table 1

// Cycles of a processor: 8 for a product, 1 for an addition, and 1 for a shift by one bit.
constexpr int Cycles(const Operations& done) {
  return 8 * done.multiplications + done.additions + done.one_bit_shifts;
}
// The same where a shift by any number of bits takes one cycle.
constexpr int CyclesOfBarrelShifts(const Operations& done) {
  return 8 * done.multiplications + done.additions + done.shifts;
}

struct CostRow {
  std::string form;
  bool printed = false;  // in the paper's table 1
  Operations paper;      // counts behind its cycles; shifts by one bit
  Operations counted;    // a row of kPaperPixels by this form, its start included
  std::string why;       // of a difference
};

// Table 1 of paper 003 and the forms it could have had.
std::vector<CostRow> CostRows();

// A pixel of each unit of this project, and what its load adds: seeds are given.
struct UnitRow {
  std::string unit, equation;
  Operations load;
  Operations pixels;  // of kUnitPixels
};
inline constexpr int kUnitPixels = 64;
std::vector<UnitRow> UnitRows();

// Markdown, a line a string.
std::vector<std::string> CostTable();
std::vector<std::string> UnitTable();

}  // namespace shading::accuracy
