// SPDX-License-Identifier: Apache-2.0
#include "sim/report/claim.h"

namespace shading::report {

const char* Name(Verdict verdict) {
  switch (verdict) {
    case Verdict::kHolds: return "holds";
    case Verdict::kHoldsInPart: return "holds in part";
    case Verdict::kFails: return "does not hold";
    case Verdict::kOnPage: return "see page";
    case Verdict::kNotMeasured: return "not measured";
  }
  return "";
}

Table ClaimTable(const std::vector<Claim>& claims) {
  Table table({"paper", "claim", "measured here", "verdict", "page"});
  for (const Claim& c : claims) {
    Entry verdict(Name(c.verdict));
    verdict.strong = c.verdict == Verdict::kHolds || c.verdict == Verdict::kFails;
    table.Add({c.source, c.claim, c.measured, verdict, c.page});
  }
  return table;
}

}  // namespace shading::report
