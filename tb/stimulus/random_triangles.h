// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/triangle_packet.h"

namespace shading::tb {

// One frame of random triangles, biased to trouble: slivers, one-pixel spans, spans across the
// whole screen, shared edges, vertices on pixel centres, near-parallel, equal and opposed normals,
// parts and wholes off the screen, back faces, zero area. Screen, light and materials depend on the
// seed too: from 16 pixels to 4096 a side.
TriangleList RandomTriangles(uint32_t seed, int count);

}  // namespace shading::tb
