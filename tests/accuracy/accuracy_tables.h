// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>

#include "tests/accuracy/worst_search.h"

namespace shading::accuracy {

// The tables of docs/accuracy.md, in markdown on standard output.
class AccuracyTables {
 public:
  explicit AccuracyTables(int divisor) : divisor_(divisor) {}  // of the effort

  void Print();
  int64_t evaluations() const { return evaluations_; }

 private:
  void PrintOverview();
  void PrintFull(Method method);
  void PrintByAngleAndLength(Method method, int fraction_bits);
  void PrintOtherIdeal();
  void PrintLargestAngles();
  void PrintLongestSpans();

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
