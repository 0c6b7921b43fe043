// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "tests/accuracy/spread_table.h"

namespace shading::accuracy {
namespace {

// A data block: the spread, then a column for each method.
std::string Data(const SpreadCells& cells, int shininess) {
  std::string data = fmt::format("$n{} << END\n", shininess);
  double degrees = 0;
  for (const SpreadCell& cell : cells.lit) {
    if (cell.light.shininess != shininess) continue;
    if (cell.degrees != degrees) {
      data += fmt::format("{}{:g}", degrees == 0 ? "" : "\n", cell.degrees);
    }
    degrees = cell.degrees;
    data += fmt::format(" {:.6g}", cell.worst.error);
  }
  return data + "\nEND\n";
}

std::string Panel(int shininess) {
  const std::string title =
      shininess == 1 ? "diffuse light" : fmt::format("specular, n = {}", shininess);
  std::string panel =
      fmt::format("set title '{}' offset 0,-0.6\nplot 1 with lines ls 9 notitle", title);
  for (size_t i = 0; i < kSpreadMethods.size(); ++i) {
    panel += fmt::format(", $n{} using 1:{} with linespoints ls {} title '{}'", shininess, i + 2,
                         i + 1, Name(kSpreadMethods[i]));
  }
  return panel + "\nunset key\n";
}

}  // namespace

std::string SpreadPlot(const SpreadCells& cells, const std::string& file) {
  std::string script;
  for (const int n : kSpreadShininess) script += Data(cells, n);
  script += fmt::format(
      "set terminal svg size 900,720 font 'sans,13' background '#ffffff'\n"
      "set output '{}'\n",
      file);
  script +=
      "set logscale xy\n"
      "set xrange [2.2:100]\n"
      "set yrange [0.0003:400]\n"
      "set xtics (2.5, 5, 10, 20, 45, 90)\n"
      "set format y '%g'\n"
      "set mytics 1\n"
      "set grid lc '#dddddd' lw 0.5\n"
      "set label 1 '1 LSB' at 2.35,1.5 textcolor '#888888' font ',11'\n"
      "set style line 1 lc '#d55e00' lw 2 pt 7 ps 0.5\n"
      "set style line 2 lc '#56b4e9' lw 5 pt 7 ps 0.9\n"
      "set style line 3 lc '#0b3d66' lw 2 dt 2 pt 1 ps 0.01\n"
      "set style line 4 lc '#009e73' lw 2 pt 5 ps 0.5\n"
      "set style line 9 lc '#888888' lw 1.5\n"
      "set xlabel 'largest angle between two vertex normals, degrees' offset 0,0.5\n"
      "set ylabel 'largest error, LSB' offset 1,0\n"
      "set key bottom right\n"
      "set multiplot layout 2,2\n";
  for (const int n : kSpreadShininess) script += Panel(n);
  return script + "unset multiplot\n";
}

}  // namespace shading::accuracy
