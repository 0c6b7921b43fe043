// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "sim/bench/results.h"
#include "sim/report/claim.h"

namespace shading::sim {

// A picture by one method and its errors, as PNG.
struct ShownPicture {
  std::string label;
  std::string picture, error_map;
  PictureError error;
};
struct Gallery {
  std::string title, command;
  std::vector<ShownPicture> pictures;
};

// report.html.
std::string BenchPage(const Results& results, const std::vector<report::Claim>& claims,
                      const Gallery& gallery);

// The same tables as Markdown.
std::string BenchMarkdown(const Results& results, const std::vector<report::Claim>& claims);

}  // namespace shading::sim
