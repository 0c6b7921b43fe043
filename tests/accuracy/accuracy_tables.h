// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

#include "tests/accuracy/worst_search.h"

namespace shading::accuracy {

// The tables of docs/accuracy.md in markdown, a line a string.
class AccuracyTables {
 public:
  explicit AccuracyTables(int divisor) : divisor_(divisor) {}  // of the effort

  std::vector<std::string> All();  // with a title before each
  std::vector<std::string> Overview();
  std::vector<std::string> Full(Method method);
  std::vector<std::string> ByAngleAndLength(Method method, int fraction_bits = Quantity::kFraction);
  std::vector<std::string> OtherIdeal();
  std::vector<std::string> LargestAngles();
  std::vector<std::string> LongestSpans();

  int64_t evaluations() const { return evaluations_; }

 private:
  double At(const Cell& cell);
  // Over all rows of the angles.
  double AtAnyAngle(const Configuration& configuration, int length, int shininess);
  double LargestAngle(Method method, Ideal ideal, int length, int shininess);
  int LongestSpan(const Configuration& configuration, int shininess);

  int divisor_;
  int64_t evaluations_ = 0;
  std::map<std::string, double> found_;  // each cell is searched once
};

}  // namespace shading::accuracy
