// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim/bench/results.h"
#include "sim/report/claim.h"

namespace shading::sim {

using Json = nlohmann::ordered_json;

// There and back, for the journal. The second of each throws std::exception for other JSON.
Json ToJson(const Cell& cell);
Cell CellFromJson(const Json& json);
Json ToJson(const SpanCurve& curve);
SpanCurve CurveFromJson(const Json& json);

// A whole run from bench.json, but for its synthesis. Throws std::exception for other JSON.
Results ResultsFromJson(const Json& json);

// bench.json and bench.csv.
Json ToJson(const Results& results, const std::vector<report::Claim>& claims);
std::string ToCsv(const Results& results);

}  // namespace shading::sim
