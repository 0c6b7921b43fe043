// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/options.h"

namespace shading::sim {

// Each returns the exit status: 0, or 1 when RTL and model differ. Bad input throws
// std::runtime_error with one line.
int Render(const Options& options);
int Verify(const Options& options);
int Cycles(const Options& options);
int RunBench(const Options& options);
int Stress(const Options& options);
int List(const Options& options);

}  // namespace shading::sim
