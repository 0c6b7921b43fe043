// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "sim/stress/stress_page.h"

namespace shading::stress {
namespace {

using nlohmann::json;

json CaseOf(const Finding& f) {
  json genes = json::array();
  for (size_t i = 0; i < f.worst.genes.size(); ++i)
    genes.push_back({{"what", f.check.genes[i]}, {"value", f.worst.genes[i]}});
  return genes;
}

json UnitsJson(const StressResults& r) {
  json units = json::array();
  for (const Finding& f : r.findings) {
    units.push_back({{"unit", f.check.unit},
                     {"worst", f.worst.error},
                     {"bound", f.check.bound},
                     {"ulp", f.check.ulp},
                     {"worst_over_bound", f.Share()},
                     {"broken", f.Broken()},
                     {"evaluations", f.worst.evaluations},
                     {"narrow", f.narrow},
                     {"valid_for", f.check.valid},
                     {"operands", CaseOf(f)}});
  }
  return units;
}

json ConditionsJson(const StressResults& r) {
  json conditions = json::array();
  for (const Condition& c : r.conditions) {
    json one = {{"family", c.family},  {"scene", c.scene}, {"measure", c.measure},
                {"cases", c.cases},    {"worst", c.worst}, {"limit", c.limit},
                {"broken", c.Broken()}};
    if (c.naive >= 0) one["naive"] = c.naive;
    conditions.push_back(one);
  }
  return conditions;
}

}  // namespace

std::string WorstLine(const Finding& f, uint32_t seed) {
  return json{{"format", "shadesim-stress-case"},
              {"version", 1},
              {"unit", f.check.unit},
              {"narrow", f.narrow},
              {"seed", seed},
              {"error", f.worst.error},
              {"bound", f.check.bound},
              {"ulp", f.check.ulp},
              {"operands", CaseOf(f)}}
      .dump();
}

json StressJson(const StressResults& r) {
  json growth = json::array(), exempt = json::array(), words = json::array();
  json heat = json::array(), references = json::array();
  for (const Growth& g : r.growth)
    growth.push_back({{"paper", g.paper},
                      {"form", g.form},
                      {"fraction_bits", g.fraction_bits},
                      {"points", g.points}});
  for (const Exempt& e : Exemptions()) exempt.push_back({{"unit", e.unit}, {"reason", e.reason}});
  for (const Word& w : r.words)
    words.push_back({{"form", w.form},
                     {"fraction_bits", w.bits},
                     {"nearest", w.nearest},
                     {"truncated", w.truncated}});
  for (const HeatMapOf& map : r.heat) {
    json cells = json::array();
    for (const Heat& h : map.cells)
      cells.push_back({{"degrees", h.degrees}, {"pixels", h.pixels}, {"codes", h.codes}});
    heat.push_back({{"title", map.title}, {"cells", cells}});
  }
  for (const Reference& f : r.references)
    references.push_back(
        {{"what", f.what}, {"unit", f.unit}, {"expected", f.expected}, {"here", f.here}});
  return {{"shadesim", r.version},  {"version", r.version},
          {"command", r.command},
          {"machine", r.machine},   {"seed", r.seed},
          {"quick", r.quick},       {"units", UnitsJson(r)},
          {"growth", growth},       {"conditions", ConditionsJson(r)},
          {"not_searched", exempt}, {"word_lengths", words},
          {"heat", heat},           {"references", references}};
}

}  // namespace shading::stress
