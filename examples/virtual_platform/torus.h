// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/triangle_packet.h"

namespace example {

// A shiny torus of 2000 triangles, tilted, lit from the upper left; orthographic.
shading::TriangleList Torus(int width, int height);

}  // namespace example
