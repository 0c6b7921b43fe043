// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/spread_table.h"

#include <fmt/format.h>

#include <algorithm>

#include "tests/accuracy/spread_text.h"

namespace shading::accuracy {
namespace {

SpreadCell Searched(Method method, const SpreadLight& light, double degrees,
                    const SpreadEffort& effort) {
  SpreadCell cell{method, light, degrees, SpreadSearch(method, light, degrees).Run(effort), {}};
  cell.product = ProductErrorsOf(method, light, cell.worst.at);
  return cell;
}

const SpreadCell& Find(const std::vector<SpreadCell>& cells, Method method, int shininess,
                       double degrees) {
  return *std::find_if(cells.begin(), cells.end(), [&](const SpreadCell& cell) {
    return cell.method == method && cell.light.shininess == shininess && cell.degrees == degrees;
  });
}

}  // namespace

SpreadLight FullLight(int shininess, bool lit) {
  const bool diffuse = shininess == 1;
  return {diffuse ? 1.0 : 0.0, diffuse ? 0.0 : 1.0, shininess, lit};
}

SpreadCells SearchCells(const SpreadEffort& effort) {
  SpreadCells cells;
  for (const int n : kSpreadShininess) {
    for (const double degrees : kSpreads) {
      for (const Method method : kSpreadMethods) {
        cells.lit.push_back(Searched(method, FullLight(n), degrees, effort));
      }
    }
  }
  for (const double degrees : kTerminatorSpreads) {
    for (const Method method : kSpreadMethods) {
      cells.terminator.push_back(Searched(method, FullLight(1, false), degrees, effort));
    }
  }
  return cells;
}

std::vector<std::string> ErrorTable(const SpreadCells& cells, int shininess) {
  std::vector<std::string> lines = {
      "| s | gouraud | expected | quad | expected | quad-split | quad-cosine | expected |",
      Rule(0, 8)};
  for (const double degrees : kSpreads) {
    std::string line = fmt::format("| {:g} |", degrees);
    for (const Method method : kSpreadMethods) {
      Add(&line, Digits(Find(cells.lit, method, shininess, degrees).worst.error));
      if (method == Method::kQuadSplit) continue;
      Add(&line, Study(ExpectedError(method, shininess, degrees)));
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> TerminatorTable(const SpreadCells& cells) {
  std::vector<std::string> lines = {"| s | gouraud | quad | expected | quad-split | quad-cosine |",
                                    Rule(0, 6)};
  for (const double degrees : kTerminatorSpreads) {
    std::string line = fmt::format("| {:g} |", degrees);
    for (const Method method : kSpreadMethods) {
      Add(&line, Digits(Find(cells.terminator, method, 1, degrees).worst.error));
      if (method == Method::kQuad) Add(&line, Study(ExpectedTerminator(method, degrees)));
    }
    lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> ProductTable(const SpreadCells& cells) {
  constexpr std::array<double, 3> kShown = {10, 30, 90};
  std::vector<std::string> lines = {"| method | light |"};
  for (const double degrees : kShown) {
    lines[0] += fmt::format(" {:g}: search | closed form | codes |", degrees);
  }
  lines.push_back(Rule(2, 3 * kShown.size()));
  for (const Method method : kSpreadMethods) {
    for (const int n : kSpreadShininess) {
      std::string line = fmt::format("| {} | {} |", Name(method), LightName(n));
      for (const double degrees : kShown) {
        const SpreadCell& cell = Find(cells.lit, method, n, degrees);
        Add(&line, Digits(cell.worst.error));
        Add(&line, Digits(cell.product.closed_form));
        Add(&line, Digits(cell.product.codes));
      }
      lines.push_back(line);
    }
  }
  return lines;
}

SpreadSummary SummaryOf(const SpreadCells& cells) {
  SpreadSummary summary;
  for (const auto* list : {&cells.lit, &cells.terminator}) {
    for (const SpreadCell& cell : *list) {
      const double form = cell.product.closed_form, searched = cell.worst.error;
      ++summary.cells;
      summary.pixels += cell.product.pixels;
      summary.unit = std::max(summary.unit, cell.product.unit);
      summary.above = std::max(summary.above, form - searched);
      summary.short_of = std::max(summary.short_of, 1 - form / searched);
    }
  }
  return summary;
}

std::vector<std::string> Summary(const SpreadCells& cells) {
  const SpreadSummary s = SummaryOf(cells);
  return {fmt::format("cells {}, pixels {}", s.cells, s.pixels),
          fmt::format("displayed codes from the method's closed form: at most {:.4f}", s.unit),
          fmt::format("closed form over the searched error: at most {:.2g} codes", s.above),
          fmt::format("closed form short of the searched error: at most {:.2g} of it", s.short_of)};
}

}  // namespace shading::accuracy
