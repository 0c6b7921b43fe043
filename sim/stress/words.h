// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace shading::stress {

// Worst error of 2048 pixels in codes with F fraction bits, by rounding of what is rounded:
// products of paper 000, start values and coefficients of paper 003.
struct Word {
  std::string form;
  int bits;  // F; of the multiplier's operand for slerp_recurrence, whose state has 10 more
  double nearest, truncated;
};
inline constexpr int kLeastWord = 10, kMostWord = 32;
std::vector<Word> WordLengths(bool quick);

// What another simulation of the same recurrences found, and what is found here.
struct Reference {
  std::string what, unit;
  double expected, here;
};
std::vector<Reference> References(bool quick);

}  // namespace shading::stress
