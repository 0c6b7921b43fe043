// SPDX-License-Identifier: Apache-2.0
#include "sim/report/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sim/report/html.h"

namespace shading::report {
namespace {

constexpr size_t kLong = 60;  // rows; longer tables scroll in a window of their own

std::string EscapeMarkdown(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string Key(const Entry& entry) {
  if (!entry.numeric) return "";
  // Numbers that are not finite sort behind all others.
  return fmt::format(" data-v=\"{}\"", std::isfinite(entry.number) ? entry.number : 1e300);
}

}  // namespace

Entry::Entry(double value) : text(Significant(value)), number(value), numeric(true) {}

Entry Entry::Count(int64_t value) {
  return Entry(static_cast<double>(value), fmt::format("{}", value));
}

void Table::Add(std::vector<Entry> row) {
  assert(row.size() == headings_.size());
  rows_.push_back(std::move(row));
}

bool Table::Numeric(size_t column) const {
  return std::any_of(rows_.begin(), rows_.end(),
                     [column](const std::vector<Entry>& row) { return row[column].numeric; });
}

std::string Table::Html() const {
  std::string html = fmt::format("<div class=\"scroll{}\"><table><thead><tr>",
                                 rows_.size() > kLong ? " long" : "");
  for (size_t c = 0; c < headings_.size(); ++c) {
    html += fmt::format("<th scope=\"col\"{}><button type=\"button\">{}</button></th>",
                        Numeric(c) ? " class=\"n\"" : "", EscapeHtml(headings_[c]));
  }
  html += "</tr></thead><tbody>\n";
  for (const std::vector<Entry>& row : rows_) {
    html += "<tr>";
    for (const Entry& entry : row) {
      const std::string text = EscapeHtml(entry.text);
      html += fmt::format("<td{}{}>{}</td>", entry.numeric ? " class=\"n\"" : "", Key(entry),
                          entry.strong ? "<b>" + text + "</b>" : text);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string Table::Markdown() const {
  std::string text = "|", rule = "|";
  for (size_t c = 0; c < headings_.size(); ++c) {
    text += fmt::format(" {} |", EscapeMarkdown(headings_[c]));
    rule += Numeric(c) ? "--:|" : "---|";
  }
  text += "\n" + rule + "\n";
  for (const std::vector<Entry>& row : rows_) {
    text += "|";
    for (const Entry& entry : row) {
      const std::string words = EscapeMarkdown(entry.text);
      text += fmt::format(" {} |", entry.strong ? "**" + words + "**" : words);
    }
    text += "\n";
  }
  return text;
}

}  // namespace shading::report
