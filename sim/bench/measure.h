// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/frame_work.h"
#include "model/triangle_packet.h"
#include "sim/bench/bench_cell.h"
#include "sim/bench/ideal_cache.h"
#include "sim/frame_buffer.h"

namespace shading::sim {

// Shades the list, all its materials at the key's shininess, by RTL and model; `picture` receives
// the RTL's. The least processor time of `repeats` runs of the model counts. Throws
// std::runtime_error when the RTL does not finish or differs from the model. `ideals` are those of
// lists of the same size.
Cell MeasureCell(const TriangleList& list, const CellKey& key, int repeats, FrameBuffer* picture,
                 IdealCache* ideals);

// Bit m: method m alone is good enough for every triangle of an auto frame, as auto judges.
uint32_t SureMethods(const FrameWork& work);

// The list with all materials at a shininess of n.
TriangleList WithShininess(TriangleList list, int n);

// Cycles of spans of each length by the RTL: `spans` of them back to back, the latter half counts.
// Their normals turn by 10 degrees; adaptive methods have a tolerance of 0.5 LSB at n = 32.
SpanCurve MeasureSpans(Method method, int lanes, const std::vector<int>& lengths, int spans);

}  // namespace shading::sim
