// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"

namespace shading {

// Bit-exact model of rtl/intensity/surface_shader.sv: a span of the methods that show interpolated
// intensities, by the units of its three channels.
class SurfaceShader {
 public:
  // Shades seed.length pixels; other methods write none. tolerance: quad-segment.
  static void Shade(Method method, const SpanSeed& seed, Tolerance tolerance, int lanes,
                    Pixel* pixels);
};

}  // namespace shading
