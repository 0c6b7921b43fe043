// SPDX-License-Identifier: Apache-2.0
#include "sim/results/stress_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <vector>

#include "sim/report/html.h"

namespace shading::sim {
namespace {

using report::Entry;
using report::Significant;
using report::Table;

// Beyond it stands what is no number.
constexpr double kNoNumber = 1e200;

Entry Size(double value) { return value < kNoNumber ? Entry(value) : Entry(value, "no number"); }

Entry Ratio(double value) { return Entry(value, fmt::format("{:.3f}", value)); }

int64_t Broken(const Json& list) {
  return std::count_if(list.begin(), list.end(),
                       [](const Json& entry) { return entry.at("broken").get<bool>(); });
}

}  // namespace

Table BoundTable(const Json& stress, const Json& narrow) {
  std::map<std::string, double> less;
  for (const Json& unit : narrow.at("units")) less[unit.at("unit")] = unit.at("worst_over_bound");
  Table table({"unit", "worst found", "bound", "ulp", "found / bound", "with a bit less", "cases"});
  for (const Json& unit : stress.at("units")) {
    const std::string name = unit.at("unit");
    const auto at = less.find(name);
    table.Add({name, Size(unit.at("worst")), Entry(unit.at("bound").get<double>()),
               unit.at("ulp").get<std::string>(), Ratio(unit.at("worst_over_bound")),
               at == less.end() ? Entry("not run") : Ratio(at->second),
               Entry::Count(unit.at("evaluations"))});
  }
  return table;
}

Table TroubleTable(const Json& stress) {
  Table table({"scene", "what is measured", "worst", "limit", "a shortcut gives", "cases"});
  for (const Json& c : stress.at("conditions")) {
    table.Add({c.at("scene").get<std::string>(), c.at("measure").get<std::string>(),
               Size(c.at("worst")), Entry(c.at("limit").get<double>()),
               c.contains("naive") ? Entry(c.at("naive").get<double>()) : Entry(""),
               Entry::Count(c.at("cases"))});
  }
  return table;
}

Table WordTable(const Json& stress) {
  std::vector<std::string> forms;
  std::map<int, std::map<std::string, std::string>> rows;
  for (const Json& word : stress.at("word_lengths")) {
    const std::string form = word.at("form");
    if (std::find(forms.begin(), forms.end(), form) == forms.end()) forms.push_back(form);
    rows[word.at("fraction_bits")][form] =
        fmt::format("{} / {}", Significant(word.at("nearest")), Significant(word.at("truncated")));
  }
  std::vector<std::string> headings = {"F"};
  headings.insert(headings.end(), forms.begin(), forms.end());
  Table table(headings);
  for (const auto& [bits, cells] : rows) {
    std::vector<Entry> row = {Entry::Count(bits)};
    for (const std::string& form : forms) {
      row.emplace_back(cells.count(form) > 0 ? cells.at(form) : std::string());
    }
    table.Add(row);
  }
  return table;
}

std::string NotSearched(const Json& stress) {
  std::vector<std::string> reasons;
  std::map<std::string, std::string> units;
  for (const Json& entry : stress.at("not_searched")) {
    const std::string reason = entry.at("reason");
    std::string& names = units[reason];
    if (names.empty()) reasons.push_back(reason);
    names += (names.empty() ? "" : ", ") + entry.at("unit").get<std::string>();
  }
  std::string text;
  for (const std::string& reason : reasons) {
    text += fmt::format("* {}: {}\n", units[reason], reason);
  }
  return text;
}

std::string BrokenWords(const Json& stress, const Json& narrow) {
  const Json &units = stress.at("units"), &conditions = stress.at("conditions");
  return fmt::format(
      "{} of {} bounds and {} of {} conditions are broken; with a bit less {} of {} bounds.",
      Broken(units), units.size(), Broken(conditions), conditions.size(),
      Broken(narrow.at("units")), narrow.at("units").size());
}

}  // namespace shading::sim
