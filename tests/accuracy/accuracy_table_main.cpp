// SPDX-License-Identifier: Apache-2.0
//
// Prints the tables of docs/accuracy.md. --quick searches with a tenth of the effort.
#include <fmt/format.h>

#include <string>
#include <string_view>

#include "tests/accuracy/accuracy_tables.h"

int main(int argc, char** argv) {
  const bool quick = argc == 2 && std::string_view(argv[1]) == "--quick";
  if (argc > 1 && !quick) {
    fmt::print(stderr, "usage: accuracy_table [--quick]\n");
    return 1;
  }
  shading::accuracy::AccuracyTables tables(quick ? 10 : 1);
  for (const std::string& line : tables.All()) fmt::print("{}\n", line);
  fmt::print("\n{} spans evaluated.\n", tables.evaluations());
  return 0;
}
