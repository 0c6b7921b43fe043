// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include <algorithm>
#include <cstring>

#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/quad_surface.h"
#include "model/normal/normal_shader.h"
#include "model/raster/pixel_walker.h"
#include "model/raster/span_binder.h"

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

// Cosines come one after the other, light in blocks.
template <int kLanes, typename Shader>
void ShadingUnit::LightSpan(Shader shader, Pixel* pixels) {
  constexpr int kBlock = PixelLightBlock::kSize;
  PixelLightBlock block;
  PixelWalker walker(seed_);
  const int length = seed_.length;
  for (int start = 0; start < length; start += kBlock) {
    const int count = std::min(kBlock, length - start);
    for (int i = 0; i < count; i += kLanes, shader.Step()) {
      const int group = kLanes == 1 ? 1 : std::min(kLanes, count - i);
      for (int lane = 0; lane < group; ++lane) {
        block.SetCosines(static_cast<size_t>(i + lane),
                         shader.At(static_cast<size_t>(lane), work_.light));
      }
    }
    const auto counts = light_.ShadeBlock(static_cast<size_t>(count), &block);
    counters_.unlit += counts.unlit;
    counters_.no_highlight += counts.no_highlight;
    for (int i = 0; i < count; ++i, walker.Step()) {
      WritePosition(walker, pixels + start + i);
      const uint32_t codes = block.codes(static_cast<size_t>(i));
      std::memcpy(&pixels[start + i].r, &codes, sizeof codes);
    }
  }
  pixels[length - 1].last = 1;
}

template <int kLanes>
void ShadingUnit::ShadeNormals(const SpanCommand& span, Pixel* pixels) {
  SpanBinder::Bind(*triangle_, span, &seed_);
  NormalSetup::Seed(SetupKindOf(work_.method), work_.light, span, kLanes, &seed_.normal);
  const NormalSeed& seed = seed_.normal;
  switch (work_.method) {
    case Method::kPhong: return LightSpan<kLanes>(LinearShader<PhongDirect, kLanes>(seed), pixels);
    case Method::kPhongTaylor:
      return LightSpan<kLanes>(LinearShader<TaylorNormalizer, kLanes>(seed), pixels);
    case Method::kPhongDuff: return LightSpan<kLanes>(DuffShader<kLanes>(seed), pixels);
    case Method::kSlerp: return LightSpan<kLanes>(SlerpShader<kLanes>(seed), pixels);
    case Method::kSlerpPaper:
      return LightSpan<kLanes>(SlerpPaperShader<kLanes>(seed, paper_fraction_bits_), pixels);
    case Method::kSlerpDirect: return LightSpan<kLanes>(SlerpDirectShader<kLanes>(seed), pixels);
    case Method::kSlerpIntensity:
      return LightSpan<kLanes>(SlerpIntensityShader<kLanes>(seed), pixels);
    default: return;
  }
}

SpanTiming ShadingUnit::Span(const SpanCommand& span, Pixel* pixels) {
  if (InterpolatesNormals(work_.method)) {
    if (clock_.lanes() == 1) {
      ShadeNormals<1>(span, pixels);
    } else {
      ShadeNormals<kMaxLanes>(span, pixels);
    }
  } else {
    // Lanes show the same intensities as one: their recurrences are exact.
    SpanSetup::Seed(work_.method, *triangle_, span, &seed_);
    switch (work_.method) {
      case Method::kGouraud: ShadeSpan<GouraudInterpolator>(seed_, pixels); break;
      case Method::kQuad: ShadeSpan<QuadSurface>(seed_, pixels); break;
      default: ShadeSpan<FlatColor>(seed_, pixels); break;
    }
  }
  const SpanTiming timing = clock_.Span(span.length, span.last);
  counters_.pixels += span.length;
  counters_.stall += timing.stall;
  counters_.setup += timing.setup;
  return timing;
}

}  // namespace shading
