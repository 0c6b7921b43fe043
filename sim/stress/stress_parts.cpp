// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/stress/stress_results.h"

namespace shading::stress {
namespace {

// JSON has no infinity.
double Finite(double value) { return std::isfinite(value) ? value : 1e300; }

PartJson ToJson(const Worst& w) {
  return {{"error", Finite(w.error)}, {"genes", w.genes}, {"evaluations", w.evaluations}};
}
Worst WorstOf(const PartJson& j) {
  return {j.at("error"), j.at("genes").get<Genes>(), j.at("evaluations")};
}

PartJson ToJson(const Condition& c) {
  return {{"family", c.family}, {"scene", c.scene},         {"measure", c.measure},
          {"cases", c.cases},   {"worst", Finite(c.worst)}, {"limit", c.limit},
          {"naive", c.naive}};
}
Condition ConditionOf(const PartJson& j) {
  return {j.at("family"), j.at("scene"), j.at("measure"), j.at("cases"),
          j.at("worst"),  j.at("limit"), j.at("naive")};
}

int64_t Evaluations(const Check& check, bool quick) {
  return std::max<int64_t>((quick ? 1000000 : 20000000) / check.cost, 24);
}

Part UnitPart(const Check& check, int narrow, uint32_t seed, StressResults* r) {
  return {fmt::format("unit {} narrow={}", check.unit, narrow),
          [check, narrow, seed, quick = r->quick] {
            return ToJson(Search(check, Evaluations(check, quick), seed, narrow));
          },
          [check, narrow, r](const PartJson& j) {
            r->findings.push_back({check, WorstOf(j), narrow});
          }};
}

Part ScenePart(size_t i, const Scene& scene, StressResults* r) {
  return {fmt::format("scene {}", i),
          [scene, quick = r->quick, seed = r->seed] { return ToJson(scene(quick, seed)); },
          [r](const PartJson& j) { r->conditions.push_back(ConditionOf(j)); }};
}

Part GrowthPart(StressResults* r) {
  return {"growth",
          [quick = r->quick] {
            PartJson all = PartJson::array();
            for (const Growth& g : GrowthCurves(quick))
              all.push_back({{"form", g.form},
                             {"bits", g.fraction_bits},
                             {"points", g.points},
                             {"paper", g.paper}});
            return all;
          },
          [r](const PartJson& all) {
            for (const PartJson& g : all)
              r->growth.push_back({g.at("form"), g.at("bits"),
                                   g.at("points").get<std::vector<std::pair<double, double>>>(),
                                   g.at("paper")});
          }};
}

Part HeatPart(const std::string& title, Form form, int bits, StressResults* r) {
  return {"heat " + title,
          [form, bits, quick = r->quick] {
            PartJson all = PartJson::array();
            for (const Heat& h : HeatMap(form, bits, quick))
              all.push_back(PartJson::array({h.degrees, h.pixels, h.codes}));
            return all;
          },
          [title, r](const PartJson& all) {
            HeatMapOf map{title, {}};
            for (const PartJson& h : all) map.cells.push_back({h.at(0), h.at(1), h.at(2)});
            r->heat.push_back(map);
          }};
}

Part WordPart(StressResults* r) {
  return {"words",
          [quick = r->quick] {
            PartJson all = PartJson::array();
            for (const Word& w : WordLengths(quick))
              all.push_back(PartJson::array({w.form, w.bits, w.nearest, w.truncated}));
            return all;
          },
          [r](const PartJson& all) {
            for (const PartJson& w : all) r->words.push_back({w.at(0), w.at(1), w.at(2), w.at(3)});
          }};
}

Part ReferencePart(StressResults* r) {
  return {"references",
          [quick = r->quick] {
            PartJson all = PartJson::array();
            for (const Reference& f : References(quick))
              all.push_back(PartJson::array({f.what, f.unit, f.expected, f.here}));
            return all;
          },
          [r](const PartJson& all) {
            for (const PartJson& f : all)
              r->references.push_back({f.at(0), f.at(1), f.at(2), f.at(3)});
          }};
}

}  // namespace

int StressResults::Broken() const {
  const auto broken = [](const auto& one) { return one.Broken(); };
  return static_cast<int>(std::count_if(findings.begin(), findings.end(), broken) +
                          std::count_if(conditions.begin(), conditions.end(), broken));
}

std::vector<Part> PartsOf(const std::string& narrow, StressResults* r) {
  std::vector<Part> parts;
  uint32_t seed = r->seed;
  for (const Check& check : AllChecks()) {
    if (narrow.empty() || narrow == "all" || narrow == check.unit)
      parts.push_back(UnitPart(check, narrow.empty() ? 0 : 1, seed, r));
    ++seed;
  }
  if (!narrow.empty()) return parts;
  const std::vector<Scene> scenes = AllScenes();
  for (size_t i = 0; i < scenes.size(); ++i) parts.push_back(ScenePart(i, scenes[i], r));
  parts.push_back(WordPart(r));
  parts.push_back(ReferencePart(r));
  parts.push_back(GrowthPart(r));
  parts.push_back(HeatPart("slerp_recurrence, state of 38 fraction bits", Form::kScaled, 38, r));
  parts.push_back(HeatPart("slerp_recurrence, 30 fraction bits", Form::kScaled, 30, r));
  parts.push_back(HeatPart("slerp_paper, 38 fraction bits", Form::kPaper, 38, r));
  parts.push_back(HeatPart("slerp_paper, 20 fraction bits", Form::kPaper, 20, r));
  return parts;
}

}  // namespace shading::stress
