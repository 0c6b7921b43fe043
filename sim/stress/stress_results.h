// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/stress/growth.h"
#include "sim/stress/search.h"
#include "sim/stress/trouble.h"
#include "sim/stress/words.h"

namespace shading::stress {

struct Finding {
  Check check;
  Worst worst;
  int narrow = 0;
  bool Broken() const { return !(worst.error <= check.bound); }
  double Share() const { return worst.error / check.bound; }  // how tight the bound is
};

struct HeatMapOf {
  std::string title;
  std::vector<Heat> cells;
};

struct StressResults {
  std::string version, command, machine;
  uint32_t seed = 1;
  bool quick = false;
  std::vector<Finding> findings;
  std::vector<Condition> conditions;
  std::vector<Growth> growth;
  std::vector<HeatMapOf> heat;
  std::vector<Word> words;
  std::vector<Reference> references;

  int Broken() const;  // bounds and conditions
};

// A part of the work: what it computed as JSON, so that a run can be stopped and go on, and what
// takes that into the results. Parts may run at the same time; Take is called in their order.
using PartJson = nlohmann::ordered_json;
struct Part {
  std::string id;
  std::function<PartJson()> run;
  std::function<void(const PartJson&)> take;
};

// Without a unit that is narrowed everything; with one only that, or "all" of them narrowed. Empty
// when there is no such unit. The results must stay where they are.
std::vector<Part> PartsOf(const std::string& narrow, StressResults* results);

}  // namespace shading::stress
