// SPDX-License-Identifier: Apache-2.0
#include "sim/results/fill_template.h"

#include <fmt/format.h>

#include <set>
#include <sstream>
#include <stdexcept>

namespace shading::sim {
namespace {

// "name" of "{{name}}", or "".
std::string NameOf(const std::string& line) {
  const bool marked = line.size() > 4 && line.compare(0, 2, "{{") == 0 &&
                      line.compare(line.size() - 2, 2, "}}") == 0;
  return marked ? line.substr(2, line.size() - 4) : "";
}

}  // namespace

std::string FillTemplate(const std::string& text, const Sections& sections) {
  std::istringstream lines(text);
  std::string filled;
  std::set<std::string> used;
  for (std::string line; std::getline(lines, line);) {
    const std::string name = NameOf(line);
    if (name.empty()) {
      filled += line + "\n";
      continue;
    }
    const auto at = sections.find(name);
    if (at == sections.end()) {
      throw std::runtime_error(fmt::format("{}: there is no such section", line));
    }
    used.insert(name);
    filled += at->second;
    if (filled.back() != '\n') filled += '\n';
  }
  for (const auto& [name, section] : sections) {
    if (used.count(name) == 0) {
      throw std::runtime_error(
          fmt::format("section {0}: the template has no line {{{{{0}}}}}", name));
    }
  }
  return filled;
}

}  // namespace shading::sim
