// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/quad_surface.h"
#include "model/raster/pixel_walker.h"

namespace shading {
namespace {

template <typename IntensityUnit>
void ShadeSpan(const SpanSeed& seed, Pixel* pixels) {
  PixelWalker walker(seed);
  IntensityUnit red(seed.channel[0]), green(seed.channel[1]), blue(seed.channel[2]);
  for (int i = 0; i < seed.length; ++i) {
    pixels[i] = {walker.x(), walker.y(), walker.z(), red.code(), green.code(), blue.code(), 0};
    walker.Step();
    red.Step();
    green.Step();
    blue.Step();
  }
  pixels[seed.length - 1].last = 1;
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
