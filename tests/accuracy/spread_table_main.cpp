// SPDX-License-Identifier: Apache-2.0
//
// Prints the tables of docs/second_order.md, "Accuracy over normal spread". --plot FILE.svg draws
// the errors with gnuplot.
#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>

#include "tests/accuracy/spread_table.h"

namespace {

void Print(const std::string& title, const std::vector<std::string>& lines) {
  fmt::print("{}\n\n", title);
  for (const std::string& line : lines) fmt::print("{}\n", line);
  fmt::print("\n");
}

bool Draw(const std::string& script) {
  std::FILE* pipe = popen("gnuplot", "w");
  if (pipe == nullptr) return false;
  std::fputs(script.c_str(), pipe);
  return pclose(pipe) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace shading::accuracy;
  const bool plot = argc == 3 && std::string_view(argv[1]) == "--plot";
  if (argc != 1 && !plot) {
    fmt::print(stderr, "usage: spread_table [--plot FILE.svg]\n");
    return 1;
  }
  const SpreadCells cells = SearchCells(kFullSearch);
  if (plot) {
    if (Draw(SpreadPlot(cells, argv[2]))) return 0;
    fmt::print(stderr, "spread_table: gnuplot cannot draw {}\n", argv[2]);
    return 1;
  }
  for (const int n : kSpreadShininess) {
    Print(n == 1 ? "Diffuse" : fmt::format("Specular, n = {}", n), ErrorTable(cells, n));
  }
  Print("Terminator", TerminatorTable(cells));
  Print("Limits", LimitTable(kFullSearch));
  Print("Turn limits", TurnLimitTable(kQuickSearch));
  Print("Through the product", ProductTable(cells));
  Print("In all cells", Summary(cells));
  return 0;
}
