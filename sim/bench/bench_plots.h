// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "sim/bench/face.h"

namespace shading::sim {

// SVG of a face's costs against RMS errors in one scene at one n: the front in colour, with names,
// the rest grey.
std::string ParetoPlot(const Results& results, const Face& face, const std::string& scene,
                       int shininess);

// SVG of cycles per span over the length of spans; methods with the same curve share it.
std::string SpanPlot(const Results& results, int lanes);

// Names and colours of the kinds of methods.
std::string KindLegend();

}  // namespace shading::sim
