// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "model/triangle_packet.h"
#include "tb/toggle_count.h"

namespace shading::test {

// Changes of bits, unit by unit, while the build with all methods shades one frame, one lane.
tb::Toggles TogglesOf(const TriangleList& list, Method method, Tolerance tolerance);

}  // namespace shading::test
