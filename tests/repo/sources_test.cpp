// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

namespace shading {
namespace {

namespace fs = std::filesystem;
const fs::path kRoot = SHADESIM_ROOT;
constexpr int64_t kColumns = 100;

// UTF-8: every byte but those that continue a character.
int64_t ColumnsOf(const std::string& line) {
  return std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xc0) != 0x80; });
}

int64_t CheckLines(const fs::path& path) {
  std::ifstream file(path);
  int64_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    EXPECT_LE(ColumnsOf(line), kColumns) << path << ":" << number;
  }
  return number;
}

TEST(Sources, NoLineIsLongerThan100Columns) {
  constexpr std::array kEndings = {".h", ".cpp", ".sv"};
  int64_t lines = 0;
  for (const char* folder : {"rtl", "model", "tb", "sim", "tests", "examples", "scripts"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder)) {
      const bool is_source = std::count(kEndings.begin(), kEndings.end(), entry.path().extension());
      if (is_source) lines += CheckLines(entry.path());
    }
  }
  EXPECT_GT(lines, 10000);
}

}  // namespace
}  // namespace shading
