// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace shading::report {

// One value of a table: what is shown, and for numbers what it is sorted by.
struct Entry {
  Entry(std::string words) : text(std::move(words)) {}  // NOLINT: rows are written as lists
  Entry(const char* words) : text(words) {}             // NOLINT
  Entry(double value);                                  // NOLINT: three significant digits
  Entry(double value, std::string shown) : text(std::move(shown)), number(value), numeric(true) {}
  static Entry Count(int64_t value);  // all digits

  std::string text;
  double number = 0;
  bool numeric = false;
  bool strong = false;  // shown in bold
};

// A table that sorts by a click on a heading; the same as Markdown for the pages. Headings carry
// the unit: "error, LSB".
class Table {
 public:
  explicit Table(std::vector<std::string> headings) : headings_(std::move(headings)) {}

  // One entry a heading.
  void Add(std::vector<Entry> row);
  size_t rows() const { return rows_.size(); }

  std::string Html() const;
  std::string Markdown() const;

 private:
  bool Numeric(size_t column) const;

  std::vector<std::string> headings_;
  std::vector<std::vector<Entry>> rows_;
};

}  // namespace shading::report
