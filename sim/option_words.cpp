// SPDX-License-Identifier: Apache-2.0
#include "sim/option_words.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string_view>

#include "sim/options.h"

namespace shading::sim {

namespace {

constexpr std::array<std::string_view, 6> kCommands = {"render", "verify", "cycles",
                                                       "bench",  "stress", "list"};

bool IsCommand(std::string_view word) {
  return std::find(kCommands.begin(), kCommands.end(), word) != kCommands.end();
}

}  // namespace

void Refuse(const std::string& what) { throw CLI::ValidationError(what); }

std::vector<double> Numbers(const std::string& option, const std::string& text, char separator,
                            size_t count) {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(text, separator)) {
    double value = 0;
    if (!CLI::detail::lexical_cast(part, value)) break;
    numbers.push_back(value);
  }
  if (numbers.size() != count) {
    Refuse(fmt::format("{} takes {} numbers separated by '{}', not '{}'", option, count, separator,
                       text));
  }
  return numbers;
}

std::vector<Method> Methods(const std::string& word) {
  if (word == "all") return {kAllMethods.begin(), kAllMethods.end()};
  for (const Method method : kAllMethods) {
    if (word == Name(method)) return {method};
  }
  std::string names;
  for (const Method method : kAllMethods) names += fmt::format("{}, ", Name(method));
  Refuse(fmt::format("unknown method '{}': take {}or all", word, names));
}

std::string SeedFault(const std::string& text) {
  uint32_t seed = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, seed);
  if (result.ec == std::errc() && result.ptr == end) return "";
  return fmt::format("takes a whole number from 0 to 4294967295, not '{}'", text);
}

void CheckCommand(int argc, char** argv) {
  std::string names;
  for (const std::string_view name : kCommands) {
    names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  }
  if (argc < 2) Refuse(fmt::format("name a command: {}", names));
  if (argv[1][0] == '-' || IsCommand(argv[1])) return;
  Refuse(fmt::format("unknown command '{}': take one of {}", argv[1], names));
}

std::string HelpOf(int argc, char** argv) {
  if (argc < 2 || !IsCommand(argv[1])) return "shadesim --help";
  return fmt::format("shadesim {} --help", argv[1]);
}

std::vector<Method> MethodList(const std::string& words) {
  std::vector<Method> methods;
  for (const std::string& word : CLI::detail::split(words, ',')) {
    for (const Method method : Methods(word)) methods.push_back(method);
  }
  std::sort(methods.begin(), methods.end());
  methods.erase(std::unique(methods.begin(), methods.end()), methods.end());
  return methods;
}

FlowPattern Options::Sink() const {
  if (backpressure.empty()) {
    Refuse("--backpressure is empty: take none, quarter, random, bits such as 110100, or a file");
  }
  try {
    if (backpressure == "none") return FlowPattern::Always();
    if (backpressure == "quarter") return FlowPattern::OneInFour();
    if (backpressure == "random") return FlowPattern::Random(seed);
    if (!std::filesystem::is_regular_file(backpressure)) {
      return FlowPattern::Recorded(backpressure);
    }
    std::ifstream file(backpressure);
    std::string bits{std::istreambuf_iterator<char>(file), {}};
    bits.erase(std::remove_if(bits.begin(), bits.end(),
                              [](char c) { return std::isspace(static_cast<unsigned char>(c)); }),
               bits.end());
    return FlowPattern::Recorded(bits);
  } catch (const std::invalid_argument& error) {
    Refuse(fmt::format("--backpressure {}: {}", backpressure, error.what()));
  }
}

}  // namespace shading::sim
