// SPDX-License-Identifier: Apache-2.0
//
// The tables of docs/accuracy.md are what the program prints, as far as a quick search can tell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "tests/accuracy/accuracy_tables.h"

namespace shading::accuracy {
namespace {

using Lines = std::vector<std::string>;

// The quick search takes the first restarts of the full one: it finds as much or less.
constexpr int kQuick = 5;
const Lines& Page() {
  static const Lines page = [] {
    Lines lines;
    std::ifstream file(SHADESIM_ROOT "/docs/accuracy.md");
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
  }();
  return page;
}

// Cells of a row, and the parts of those that hold several numbers: "0.5 / 1.2".
Lines PartsOf(std::string row) {
  std::replace(row.begin(), row.end(), '/', '|');
  Lines parts;
  std::istringstream text(row);
  for (std::string part; std::getline(text, part, '|');) parts.push_back(part);
  return parts;
}

// What a quick search may say where the page has `full`: never more than `most` of it, and hardly
// ever less than `least`.
struct Range {
  double least, most;
};
constexpr Range kLess = {0.5, 1.0};
constexpr double kMissed = 0.1;  // part of a table's cells in which the quick search finds little

struct Verdict {
  size_t rows = 0;  // that agree, from the header on
  int cells = 0, little = 0;

  bool Good(size_t all) const { return rows == all && little <= kMissed * cells; }
};

bool AddCell(const std::string& quick, const std::string& full, const Range& range,
             Verdict* verdict) {
  ++verdict->cells;
  if (quick == full) return true;
  const double value = std::atof(quick.c_str()), page = std::atof(full.c_str());
  const double last_digit = page < 1 ? 0.0001 : page < 9.95 ? 0.1 : 1;
  verdict->little += value < range.least * page;
  return value > 0 && value <= range.most * page + last_digit;
}

bool AddRow(const std::string& quick, const std::string& page, size_t labels, const Range& range,
            Verdict* verdict) {
  const Lines left = PartsOf(quick), right = PartsOf(page);
  if (left.size() != right.size()) return false;
  for (size_t i = 0; i < left.size(); ++i) {
    const bool is_label = i <= labels;  // what is left of the first bar is empty
    const bool good = is_label ? left[i] == right[i] : AddCell(left[i], right[i], range, verdict);
    if (!good) return false;
  }
  ++verdict->rows;
  return true;
}

// One of the page's tables with this header has all of the rows.
void ExpectOnPage(const Lines& table, size_t labels, const Range& range) {
  Verdict best;
  const Lines& page = Page();
  for (size_t at = 0; at + table.size() <= page.size(); ++at) {
    if (page[at] != table[0]) continue;
    Verdict verdict{1, 0, 0};
    while (verdict.rows < table.size() &&
           AddRow(table[verdict.rows], page[at + verdict.rows], labels, range, &verdict)) {
    }
    if (verdict.rows > best.rows || verdict.Good(table.size())) best = verdict;
    if (best.Good(table.size())) return;
  }
  if (best.rows < table.size()) {
    ADD_FAILURE() << "not on the page: " << table[best.rows];
  } else {
    ADD_FAILURE() << "too little found in " << best.little << " of " << best.cells << " cells";
  }
}

// One test: cells that a table has searched serve the next.
TEST(AccuracyPage, TablesAreThoseOfTheProgram) {
  AccuracyTables quick(kQuick);
  ExpectOnPage(quick.Overview(), 1, kLess);
  ExpectOnPage(quick.Full(Method::kSlerp), 2, kLess);
  ExpectOnPage(quick.Full(Method::kSlerpIntensity), 2, kLess);
  for (const Method method :
       {Method::kPhong, Method::kPhongTaylor, Method::kPhongDuff, Method::kSlerpDirect}) {
    SCOPED_TRACE(Name(method));
    ExpectOnPage(quick.ByAngleAndLength(method), 1, kLess);
  }
  for (const int bits : {16, 20, 24, 30, 38}) {
    SCOPED_TRACE(bits);
    ExpectOnPage(quick.ByAngleAndLength(Method::kSlerpPaper, bits), 1, kLess);
  }
  ExpectOnPage(quick.OtherIdeal(), 1, kLess);
  // A smaller search finds a failure later.
  ExpectOnPage(quick.LargestAngles(), 2, {1, 1.1});
}

}  // namespace
}  // namespace shading::accuracy
