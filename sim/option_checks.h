// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/options.h"

namespace shading::sim {

// What options do not fit together. Throws CLI::ValidationError.
void CheckOptions(const Options& options);

// That every file and folder of results can be written. Throws std::runtime_error, one line.
void CheckOutputs(const Options& options);

}  // namespace shading::sim
