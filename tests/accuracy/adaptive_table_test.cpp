// SPDX-License-Identifier: Apache-2.0
//
// The guarantee of the adaptive method, searched, and what the other two miss; the page
// docs/adaptive.md says the same.
#include "tests/accuracy/adaptive_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

namespace shading::accuracy {
namespace {

// Prints the table, and looks for it in the page.
void ExpectOnThePage(const std::vector<std::string>& table) {
  std::ifstream file(SHADESIM_ROOT "/docs/adaptive.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& line : table) {
    std::cout << line << '\n';
    EXPECT_NE(page.find(line + '\n'), std::string::npos) << "not on the page: " << line;
  }
}

// Within the tolerance and 0.2 codes of slerp on every span that the search meets, and close to the
// tolerance, or the search would be blind.
TEST(AdaptiveTable, GuaranteeHolds) {
  for (const double tolerance : kTolerances) {
    for (const int n : kAdaptiveShininess) {
      const AdaptiveWorst worst = WorstAdaptive(Method::kAdaptive, tolerance, n);
      EXPECT_LE(worst.lsb, tolerance + kFixedPoint) << "n = " << n;
      EXPECT_GE(worst.lsb, 0.95 * tolerance) << "n = " << n;
    }
  }
  ExpectOnThePage(GuaranteeTable());
}

TEST(AdaptiveTable, GuaranteeHoldsForReflectedLight) {
  for (const double tolerance : kTolerances) {
    for (const int n : {1, 8, 32, 128}) {
      const double worst = WorstReflected(tolerance, n);
      EXPECT_LE(worst, tolerance + kFixedPoint) << "n = " << n;
      EXPECT_GE(worst, 0.9 * tolerance) << "n = " << n;
    }
  }
}

// The paper's extension to 2^k steps misses the end of the span, whatever the tolerance.
TEST(AdaptiveTable, ExtensionHasNoGuarantee) {
  EXPECT_GT(WorstExtended(15, 1).lsb, 2);
  EXPECT_GT(WorstExtended(30, 1).lsb, 13);
  EXPECT_GT(WorstExtended(30, 128).lsb, 80);
  ExpectOnThePage(ExtensionTable());
}

TEST(AdaptiveTable, ChordAgainstPhong) { ExpectOnThePage(ChordTable()); }

}  // namespace
}  // namespace shading::accuracy
