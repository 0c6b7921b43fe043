// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>

// Cells and lines of the Markdown tables of spread_table.
namespace shading::accuracy {

// Three digits, no more decimals than that takes.
inline std::string Digits(double value) {
  if (value >= 100) return fmt::format("{:.0f}", value);
  if (value >= 10) return fmt::format("{:.1f}", value);
  if (value >= 1) return fmt::format("{:.2f}", value);
  return fmt::format("{:.3g}", value);
}
inline std::string Study(double value) { return value == 0 ? "" : fmt::format("{:g}", value); }

// A row of a Markdown table.
inline void Add(std::string* line, const std::string& text) { *line += " " + text + " |"; }

inline std::string Rule(size_t left, size_t right) {
  std::string line = "|";
  for (size_t i = 0; i < left; ++i) line += "---|";
  for (size_t i = 0; i < right; ++i) line += "--:|";
  return line;
}

inline std::string LightName(int shininess) {
  return shininess == 1 ? "diffuse" : fmt::format("specular, n = {}", shininess);
}

}  // namespace shading::accuracy
