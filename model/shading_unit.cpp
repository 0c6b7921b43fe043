// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include <cstring>

#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/quad_surface.h"
#include "model/raster/pixel_walker.h"

namespace shading {
namespace {

// A pixel is written as two words, its fields from the lowest byte up: fewer and wider stores.
static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "Pixel is written in words");

void WritePosition(const PixelWalker& walker, Pixel* pixel) {
  const uint64_t word = walker.x() | static_cast<uint64_t>(walker.y()) << 16 |
                        static_cast<uint64_t>(walker.z()) << 32;
  std::memcpy(&pixel->x, &word, sizeof word);
}

// Clears `last`, too. Few pixels need a clamp, so one test serves three channels.
void WriteColor(int64_t r, int64_t g, int64_t b, Pixel* pixel) {
  if (((r | g | b) & ~Code::kMaxRaw) != 0) {
    r = ClampCode(r);
    g = ClampCode(g);
    b = ClampCode(b);
  }
  const auto word = static_cast<uint32_t>(r | g << 8 | b << 16);
  std::memcpy(&pixel->r, &word, sizeof word);
}

template <typename IntensityUnit>
void ShadeSpan(const SpanSeed& seed, Pixel* pixels) {
  const int length = seed.length;
  PixelWalker walker(seed);
  IntensityUnit red(seed.channel[0]), green(seed.channel[1]), blue(seed.channel[2]);
  for (int i = 0; i < length; ++i) {
    WritePosition(walker, pixels + i);
    WriteColor(red.whole(), green.whole(), blue.whole(), pixels + i);
    walker.Step();
    red.Step();
    green.Step();
    blue.Step();
  }
  pixels[length - 1].last = 1;
}

}  // namespace

SpanTiming ShadingUnit::Span(const SpanCommand& span, Pixel* pixels) {
  SpanSetup::Seed(method_, *triangle_, span, &seed_);
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
