// SPDX-License-Identifier: Apache-2.0
//
// Writes docs/results.md from what scripts/results.sh measured.
#include <fmt/format.h>

#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "sim/io/atomic_file.h"
#include "sim/results/page_sections.h"

namespace {

using namespace shading::sim;

std::string ReadText(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  return {std::istreambuf_iterator<char>(file), {}};
}

void WritePage(const std::string& template_path, const std::string& folder_path,
               const std::string& page) {
  RunFolder folder(folder_path);
  const std::string text = FillTemplate(ReadText(template_path), MakeSections(&folder));
  WriteWhole(page, kGenerated + text);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) {
    fmt::print(
        stderr,
        "Usage: results_page TEMPLATE DIR PAGE   from what scripts/results.sh wrote to DIR\n");
    return 2;
  }
  try {
    WritePage(argv[1], argv[2], argv[3]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "results_page: {}\n", error.what());
    return 2;
  }
  return 0;
}
