// SPDX-License-Identifier: Apache-2.0
//
// Prints the tables of errors of docs/adaptive.md.
#include <fmt/format.h>

#include "tests/accuracy/adaptive_table.h"

int main() {
  using namespace shading::accuracy;
  for (const auto& table : {GuaranteeTable(), ExtensionTable(), ChordTable()}) {
    for (const std::string& line : table) fmt::print("{}\n", line);
    fmt::print("\n");
  }
  return 0;
}
