// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/stress/growth.h"
#include "sim/stress/search.h"

namespace shading::stress {

struct Finding {
  Check check;
  Worst worst;
  int narrow = 0;
  bool Broken() const { return worst.error > check.bound; }
  double Share() const { return worst.error / check.bound; }  // how tight the bound is
};

struct StressResults {
  std::string version, command;
  uint32_t seed = 1;
  std::vector<Finding> findings;
  std::vector<Growth> growth;
  std::vector<Heat> slerp, paper;
};

nlohmann::json StressJson(const StressResults& results);
std::string WorstLine(const Finding& finding, uint32_t seed);  // one line of JSON, for --replay
std::string StressPage(const StressResults& results);

}  // namespace shading::stress
