// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/quad_surface.h"
#include "model/raster/pixel_walker.h"

namespace shading {
namespace {

// Positions first, then colours: each loop keeps its state in registers.
template <typename IntensityUnit>
void ShadeSpan(const SpanSeed& seed, Pixel* pixels) {
  const int length = seed.length;
  PixelWalker walker(seed);
  for (int i = 0; i < length; ++i) {
    pixels[i].x = walker.x();
    pixels[i].y = walker.y();
    pixels[i].z = walker.z();
    walker.Step();
  }
  IntensityUnit red(seed.channel[0]), green(seed.channel[1]), blue(seed.channel[2]);
  for (int i = 0; i < length; ++i) {
    pixels[i].r = red.code();
    pixels[i].g = green.code();
    pixels[i].b = blue.code();
    pixels[i].last = i == length - 1;
    red.Step();
    green.Step();
    blue.Step();
  }
}

}  // namespace

SpanTiming ShadingUnit::Span(const SpanCommand& span, Pixel* pixels) {
  seed_ = SpanSetup::Seed(method_, *triangle_, span);
  switch (method_) {
    case Method::kFlat: ShadeSpan<FlatColor>(seed_, pixels); break;
    case Method::kGouraud: ShadeSpan<GouraudInterpolator>(seed_, pixels); break;
    case Method::kQuad: ShadeSpan<QuadSurface>(seed_, pixels); break;
  }
  const SpanTiming timing = clock_.Span(span.length, span.last);
  counters_.pixels += span.length;
  counters_.stall += timing.stall;
  counters_.setup += timing.setup;
  return timing;
}

}  // namespace shading
