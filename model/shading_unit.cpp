// SPDX-License-Identifier: Apache-2.0
#include "model/shading_unit.h"

#include <algorithm>
#include <cstring>

#include "model/footprint/footprint_shader.h"
#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/lane_seed.h"
#include "model/intensity/quad_difference.h"
#include "model/intensity/quad_horner.h"
#include "model/intensity/quad_midpoint.h"
#include "model/intensity/quad_polynomial.h"
#include "model/intensity/quad_segment.h"
#include "model/intensity/quad_split.h"
#include "model/intensity/quad_step.h"
#include "model/intensity/quad_surface.h"
#include "model/intensity/quad_third_difference.h"
#include "model/intensity/quad_three_term.h"
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

// make(channel) is the unit of one channel.
template <typename Make>
void ShadeSpan(const SpanSeed& seed, const Make& make, Pixel* pixels) {
  const int length = seed.length;
  PixelWalker walker(seed);
  auto red = make(0), green = make(1), blue = make(2);
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

// A method whose lanes show the same intensities as one: their recurrences are exact.
template <typename Unit>
void ShadeCurve(const SpanSeed& seed, Pixel* pixels) {
  ShadeSpan(
      seed, [&](size_t ch) { return Unit(seed.channel[ch]); }, pixels);
}
template <typename Unit>
void ShadePoints(const SpanSeed& seed, Pixel* pixels) {
  ShadeSpan(
      seed, [&](size_t ch) { return Unit(seed.point[ch]); }, pixels);
}

// The segments of each lane are its own.
class LaneSegments {
 public:
  LaneSegments(const ChannelSeed& seed, Tolerance tolerance, int lanes)
      : lane_{Lane(seed, 0, tolerance, lanes), Lane(seed, 1, tolerance, lanes),
              Lane(seed, 2, tolerance, lanes), Lane(seed, 3, tolerance, lanes)},
        lanes_(lanes) {}
  int64_t whole() const { return lane_[at_].whole(); }
  void Step() {
    lane_[at_].Step();
    at_ = at_ + 1 == static_cast<size_t>(lanes_) ? 0 : at_ + 1;
  }

 private:
  static QuadSegment Lane(const ChannelSeed& seed, int lane, Tolerance tolerance, int lanes) {
    return QuadSegment(LaneSeed::Of(seed, lane, lanes), tolerance);
  }

  std::array<QuadSegment, kMaxLanes> lane_;
  size_t at_ = 0;
  int lanes_;
};

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
  if (choice_.method == Method::kQuadCosine) {
    SpanSetup::Seed(choice_.method, *triangle_, span, &seed_);
    return LightSpan<kLanes>(QuadCosineShader<kLanes>(seed_.cosine), pixels);
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

void ShadingUnit::ShadeIntensities(Pixel* pixels) const {
  const SpanSeed& seed = seed_;
  switch (choice_.method) {
    case Method::kFlat: return ShadeCurve<FlatColor>(seed, pixels);
    case Method::kGouraud: return ShadeCurve<GouraudInterpolator>(seed, pixels);
    case Method::kQuad:
    case Method::kQuadFootprint: return ShadeCurve<QuadSurface>(seed, pixels);
    case Method::kQuadPolynomial: return ShadePoints<QuadPolynomial>(seed, pixels);
    case Method::kQuadHorner: return ShadePoints<QuadHorner>(seed, pixels);
    case Method::kQuadStep: return ShadeCurve<QuadStep>(seed, pixels);
    case Method::kQuadMidpoint: return ShadeCurve<QuadMidpoint>(seed, pixels);
    case Method::kQuadThreeTerm: return ShadeCurve<QuadThreeTerm>(seed, pixels);
    case Method::kQuadThirdDifference: return ShadeCurve<QuadThirdDifference>(seed, pixels);
    case Method::kQuadDifference: return ShadeCurve<QuadDifference>(seed, pixels);
    case Method::kQuadSegment:
      return ShadeSpan(
          seed,
          [&](size_t ch) {
            return LaneSegments(seed.channel[ch], work_.tolerance, clock_.lanes());
          },
          pixels);
    case Method::kQuadSplit:
      return ShadeSpan(
          seed, [&](size_t ch) { return QuadSplit(seed.channel[ch], seed.split[ch]); }, pixels);
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
  counters_.unnormalised += lit && choice_.method != Method::kPhongDuff;
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
    ShadeIntensities(pixels);
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
