// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include <algorithm>
#include <cstring>

#include "model/footprint/footprint_shader.h"
#include "model/intensity/surface_shader.h"
#include "model/normal/normal_shader.h"
#include "model/raster/pixel_words.h"
#include "model/raster/span_binder.h"

namespace shading {

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

// Mean of the samples' light, pixel by pixel.
template <int kLanes>
void ShadingUnit::LightFootprints(const SpanCommand& span, Pixel* pixels) {
  FootprintShader<kLanes> shader(seed_.normal, triangle_->footprint, span.margin);
  PixelWalker walker(seed_);
  size_t lane = 0;
  for (int i = 0; i < span.length; ++i, walker.Step()) {
    const FootprintMean::Light mean = shader.Mean(lane, sample_light_);
    const PixelCodes codes = sample_light_.CodesOf(mean);
    WritePosition(walker, pixels + i);
    WriteColor(codes.r, codes.g, codes.b, pixels + i);
    counters_.unlit += mean.unlit;
    counters_.no_highlight += mean.skipped;
    if (++lane < kLanes) continue;
    lane = 0;
    shader.Step();
  }
  pixels[span.length - 1].last = 1;
  const int64_t taken = shader.taken();
  const int64_t positions = SampleCount(triangle_->footprint.pattern);
  counters_.samples_taken += taken;
  counters_.samples_excluded += span.length * positions - taken;
  counters_.samples_saved += span.length * (kMostSamples - positions);
}

template <int kLanes>
void ShadingUnit::LightPixels(const SpanCommand& span, Pixel* pixels) {
  if (InterpolatesCosines(choice_.method)) {
    SpanSetup::Seed(choice_.method, *triangle_, span, &seed_);
    return choice_.method == Method::kQuadCosine
               ? LightSpan<kLanes>(QuadCosineShader<kLanes>(seed_.curve), pixels)
               : LightSpan<kLanes>(PhongSurfaceShader<kLanes>(seed_.curve), pixels);
  }
  SpanBinder::Bind(*triangle_, span, &seed_);
  if (IsAdaptive(choice_.method)) {
    const AdaptiveSegment* begin = segments_.data();
    return LightSpan<kLanes>(AdaptiveShader<kLanes>(begin, begin + segments_.size()), pixels);
  }
  NormalSetup::Seed(SetupKindOf(choice_.method), work_.light, span, kLanes, &seed_.normal);
  const NormalSeed& seed = seed_.normal;
  if (IsFootprint(choice_.method)) return LightFootprints<kLanes>(span, pixels);
  switch (choice_.method) {
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

void ShadingUnit::Triangle(const TriangleState& triangle) {
  triangle_ = &triangle;
  const auto index = static_cast<size_t>(triangle.material);
  if (work_.method == Method::kAuto) {
    choice_ = MethodChoice::Of(triangle.range, work_.limits[index], work_.light.lighting);
    counters_.ambient += choice_.ambient;
  }
  if (LightsPixels(choice_.method)) {
    const Material& material = work_.materials[index];
    light_.SetMaterial(material, !choice_.dark);
    if (IsFootprint(choice_.method)) sample_light_.SetMaterial(material);
  }
  clock_.Triangle(choice_.method);
  row_ = triangle.origin_y;
}

void ShadingUnit::CountSkips() {
  const bool lit = LightsPixels(choice_.method);
  counters_.constant += choice_.method == Method::kFlat;
  counters_.dark += lit && choice_.dark;
  counters_.unnormalised += lit && choice_.method != Method::kPhongDuff &&
                            choice_.method != Method::kPhongSurface;
  for (int channel = 0; channel < kChannels; ++channel) {
    counters_.black += (choice_.channels >> channel & 1) == 0;
  }
}

// Into segments; returns the cycles of set-up.
int ShadingUnit::Divide(const SpanCommand& span) {
  AdaptiveNormalizer normalizer(AdaptiveKindOf(choice_.method), span.normal, span.length,
                                triangle_->limit);
  segments_.clear();
  AdaptiveSegment segment;
  while (normalizer.Next(&segment)) segments_.push_back(segment);
  counters_.normalised += normalizer.normalisations();
  counters_.skipped += normalizer.skipped();
  return normalizer.setup_cycles();
}

SpanTiming ShadingUnit::Span(const SpanCommand& span, Pixel* pixels) {
  const bool adaptive = IsAdaptive(choice_.method);
  const int setup_cycles = adaptive ? Divide(span) : 0;
  if (work_.method == Method::kAuto) CountSkips();
  if (LightsPixels(choice_.method)) {
    if (clock_.lanes() == 1) {
      LightPixels<1>(span, pixels);
    } else {
      LightPixels<kMaxLanes>(span, pixels);
    }
  } else {
    SpanSetup::Seed(choice_.method, *triangle_, span, &seed_);
    SurfaceShader::Shade(choice_.method, seed_, work_.tolerance, clock_.lanes(), pixels);
  }
  const int samples = IsFootprint(choice_.method) ? SampleCount(triangle_->footprint.pattern) : 1;
  const SpanTiming timing = adaptive ? clock_.AdaptiveSpan(setup_cycles, segments_, span.last)
                                     : clock_.Span(span.length, span.y - row_, span.last, samples);
  row_ = span.y;
  counters_.pixels += span.length;
  counters_.stall += timing.stall;
  counters_.setup += timing.setup;
  return timing;
}

}  // namespace shading
