// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace shading::sim {

// What times depend on, in one line: processor, cores, memory, system, compiler, Verilator.
std::string DescribeMachine();

}  // namespace shading::sim
