// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sim/stress/check.h"

namespace shading::stress {

// Codes by which the worst pixel of a span of AdaptiveKind::kSphere is farther from slerp than the
// tolerance asked for. Operands as in SetupChecks.
double AdaptiveExcess(const Genes& genes, int narrow);

}  // namespace shading::stress
