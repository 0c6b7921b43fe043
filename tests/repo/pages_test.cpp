// SPDX-License-Identifier: Apache-2.0
//
// The pages say what the contracts say, and every link leads somewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>

#include "model/contracts.h"

namespace shading {
namespace {

namespace fs = std::filesystem;
const fs::path kRoot = SHADESIM_ROOT;

std::string ReadFile(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

fs::path PageOf(const UnitContract& unit) {
  const std::string group = unit.group;
  const fs::path units = kRoot / "docs/units";
  return (group == "top" ? units : units / group) / (std::string(unit.name) + ".md");
}

// The cell beside `name` in the contract table, or "".
std::string Cell(const std::string& page, const std::string& name) {
  std::smatch match;
  const std::regex row("\\| " + name + " \\| ([^|\n]*?) *\\|");
  return std::regex_search(page, match, row) ? match[1].str() : "";
}

double LeadingNumber(const std::string& text) {
  return text.empty() || text == "none" ? 0 : std::stod(text);
}

TEST(Pages, ContractTablesEqualTheContracts) {
  for (const UnitContract& unit : kContracts) {
    SCOPED_TRACE(unit.name);
    ASSERT_TRUE(fs::exists(PageOf(unit)));
    const std::string page = ReadFile(PageOf(unit));
    ASSERT_NE(Cell(page, "Latency"), "");
    ASSERT_NE(Cell(page, "Interval"), "");
    ASSERT_NE(Cell(page, "Error"), "");
    EXPECT_EQ(LeadingNumber(Cell(page, "Latency")), unit.latency_cycles);
    EXPECT_EQ(LeadingNumber(Cell(page, "Interval")), unit.interval_cycles);
    EXPECT_DOUBLE_EQ(LeadingNumber(Cell(page, "Error")), unit.max_error_ulp);
    EXPECT_EQ(Cell(page, "Input"), unit.input);
    EXPECT_EQ(Cell(page, "Output"), unit.output);
    EXPECT_EQ(Cell(page, "Valid for"), unit.valid_for);
  }
}

TEST(Pages, ReadmeNamesEveryUnit) {
  const std::string readme = ReadFile(kRoot / "README.md");
  for (const UnitContract& unit : kContracts) {
    EXPECT_NE(readme.find(std::string("[") + unit.name + "]"), std::string::npos) << unit.name;
  }
}

TEST(Pages, ReadmeIsShort) {
  const std::string readme = ReadFile(kRoot / "README.md");
  EXPECT_LT(std::count(readme.begin(), readme.end(), '\n'), 150);
}

// FNV-1a of 64 bits, as scripts/diagrams.mjs has it.
std::string Hash(const std::string& text) {
  uint64_t value = 0xcbf29ce484222325u;
  for (const char c : text) value = (value ^ static_cast<uint8_t>(c)) * 0x100000001b3u;
  std::ostringstream hex;
  hex << std::hex << std::setw(16) << std::setfill('0') << value;
  return hex.str();
}

TEST(Pages, DiagramsAreDrawnFromTheRtlAsItIs) {
  for (const std::string unit : {"quad_surface", "quad_third_difference"}) {
    const std::string path = "rtl/intensity/" + unit + ".sv";
    const std::string picture = ReadFile(kRoot / "docs/images" / (unit + ".svg"));
    EXPECT_NE(picture.find(path + " " + Hash(ReadFile(kRoot / path))), std::string::npos)
        << unit << ": run scripts/diagrams.sh";
    const std::string page = ReadFile(kRoot / "docs/units/intensity" / (unit + ".md"));
    EXPECT_NE(page.find("images/" + unit + ".svg"), std::string::npos) << "the page shows it";
  }
}

// A line such as TABLE, left for a program to fill.
bool IsPlaceholder(const std::string& line) {
  return line.size() >= 4 && line.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == line.npos;
}

void ExpectNoPlaceholder(const fs::path& path) {
  std::ifstream file(path);
  int number = 1;
  for (std::string line; std::getline(file, line); ++number) {
    EXPECT_FALSE(IsPlaceholder(line)) << path << ":" << number << ": " << line;
  }
  EXPECT_GT(number, 1) << path;
}

TEST(Pages, NoPlaceholderIsLeft) {
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "docs")) {
    if (entry.path().extension() == ".md") ExpectNoPlaceholder(entry.path());
  }
  ExpectNoPlaceholder(kRoot / "README.md");
  ExpectNoPlaceholder(kRoot / "CONTRIBUTING.md");
}

TEST(Pages, LinksLeadSomewhere) {
  const std::regex link("\\]\\(([^)#:]+)\\)");
  int links = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "docs")) {
    if (entry.path().extension() != ".md") continue;
    const std::string page = ReadFile(entry.path());
    for (std::sregex_iterator at(page.begin(), page.end(), link), end; at != end; ++at, ++links) {
      EXPECT_TRUE(fs::exists(entry.path().parent_path() / (*at)[1].str()))
          << entry.path() << " links to " << (*at)[1];
    }
  }
  const std::string readme = ReadFile(kRoot / "README.md");
  for (std::sregex_iterator at(readme.begin(), readme.end(), link), end; at != end; ++at, ++links) {
    EXPECT_TRUE(fs::exists(kRoot / (*at)[1].str())) << "README links to " << (*at)[1];
  }
  EXPECT_GT(links, 10);
}

}  // namespace
}  // namespace shading
