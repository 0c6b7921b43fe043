// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/raster/turn_limit.h"
#include "tests/accuracy/spread_table.h"
#include "tests/accuracy/spread_text.h"

namespace shading::accuracy {
namespace {

// What the rule of TurnLimitDegrees allows, in parts of what the search allows.
double PartOfLimit(Method method, const SpreadLight& light, double codes,
                   const SpreadEffort& effort) {
  Material material;
  material.diffuse.fill(Reflectance::Round(light.diffuse));
  material.specular.fill(Reflectance::Round(light.specular));
  material.shininess = Shininess::FromRaw(int64_t{light.shininess} << Shininess::kFraction);
  return TurnLimitDegrees(method, material, codes) / SearchedLimit(method, light, codes, effort);
}

}  // namespace

std::vector<std::string> LimitTable(const SpreadEffort& effort) {
  std::vector<std::string> lines = {
      "| method | light | 1/2 LSB | expected | 1 LSB | expected | 2 LSB | expected |", Rule(2, 6)};
  for (const Method method : kSpreadMethods) {
    for (const int n : kSpreadShininess) {
      std::string line = fmt::format("| {} | {} |", Name(method), LightName(n));
      for (const double codes : kLimitCodes) {
        Add(&line, Digits(SearchedLimit(method, FullLight(n), codes, effort)));
        Add(&line, Study(ExpectedLimit(method, n, codes)));
      }
      lines.push_back(line);
    }
  }
  return lines;
}

std::vector<std::string> TurnLimitTable(const SpreadEffort& effort) {
  std::vector<std::string> lines = {"| method |"};
  for (const int n : kTurnShininess) lines[0] += fmt::format(" n = {} |", n);
  lines.push_back(Rule(1, kTurnShininess.size()));
  for (const Method method : kSpreadMethods) {
    std::string line = fmt::format("| {} |", Name(method));
    for (const int n : kTurnShininess) {
      double least = 1e9, most = 0;
      for (const int parts : {1, 2, 3, 4, 5, 6, 7, 8}) {  // 3 kd + ks, in halves
        for (const double codes : {0.5, 1.0, 2.0, 4.0}) {
          const SpreadLight light = {parts / 3 * 0.5, parts % 3 * 0.5, n, true};
          const double part = PartOfLimit(method, light, codes, effort);
          least = std::min(least, part);
          most = std::max(most, part);
        }
      }
      Add(&line, fmt::format("{:.2f} - {:.2f}", least, most));
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace shading::accuracy
