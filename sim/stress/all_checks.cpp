// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/check.h"

namespace shading::stress {

Check CheckOf(const UnitContract& unit, const std::string& ulp, const std::string& narrowed) {
  Check check;
  check.unit = unit.name;
  check.bound = unit.max_error_ulp;
  check.valid = unit.valid_for;
  check.ulp = ulp;
  check.narrowed = narrowed;
  return check;
}

std::vector<Check> AllChecks() {
  std::vector<Check> all;
  for (const auto family : {RecurrenceChecks, QuadChecks, NormalChecks, SetupChecks, LightChecks,
                            VertexChecks, TriangleChecks}) {
    for (Check& check : family()) all.push_back(std::move(check));
  }
  return all;
}

std::vector<Exempt> Exemptions() {
  std::vector<Exempt> exempt;
  const std::vector<Check> checks = AllChecks();
  for (const UnitContract& unit : kContracts) {
    const auto same = [&](const Check& c) { return c.unit == unit.name; };
    if (std::any_of(checks.begin(), checks.end(), same)) continue;
    exempt.push_back(
        {unit.name, unit.max_error_ulp == 0
                        ? "exact: states no error, every bit is compared by equality tests"
                        : "its bound is not searched"});
  }
  return exempt;
}

}  // namespace shading::stress
