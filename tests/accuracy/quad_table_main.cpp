// SPDX-License-Identifier: Apache-2.0
//
// Prints the tables of docs/second_order.md. --growth FILE writes the drift by pixel for gnuplot.
#include <fmt/format.h>

#include <fstream>
#include <string>
#include <string_view>

#include "sim/stress/quad_drift.h"
#include "tests/accuracy/quad_table.h"

namespace {

void Print(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) fmt::print("{}\n", line);
  fmt::print("\n");
}

}  // namespace

int main(int argc, char** argv) {
  using namespace shading::accuracy;
  if (argc == 3 && std::string_view(argv[1]) == "--growth") {
    std::ofstream file(argv[2]);
    for (const std::string& line : DriftGrowth()) file << line << '\n';
    file.close();
    if (!file) fmt::print(stderr, "quad_table: cannot write {}\n", argv[2]);
    return file ? 0 : 1;
  }
  if (argc != 1) {
    fmt::print(stderr, "usage: quad_table [--growth FILE]\n");
    return 1;
  }
  Print(CostTable());
  Print(UnitTable());
  Print(DriftTable());
  return 0;
}
