// SPDX-License-Identifier: Apache-2.0
#include "model/light/pixel_light_block.h"

#include "model/light/specular_cosine.h"
#include "model/light/specular_math.h"

// All passes are compiled as one function for the vector registers of three generations of
// processors; the program takes the best that its machine has.
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__GNUC__) && !defined(__clang__)
#define SHADESIM_VECTOR_CLONES \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#define SHADESIM_PASS __attribute__((always_inline)) inline
#else
#define SHADESIM_VECTOR_CLONES
#define SHADESIM_PASS inline
#endif

namespace shading {

// Every pass is over `groups` groups.
struct PixelLightBlock::Passes {
  struct Sums {
    int32_t unlit, no_highlight, visible;
  };
  static void Fill(Cosines* cosines, size_t begin);  // one group
  static void Reflect(PixelLightBlock* block, size_t groups, int64_t l_dot_v);
  static Sums Count(const PixelLightBlock* block, size_t groups, int32_t least_visible);
  static void SplitOctaves(PixelLightBlock* block, size_t groups, int32_t least_visible);
  static void TimesShininess(PixelLightBlock* block, size_t groups, uint32_t shininess);
  static void RoundPower(PixelLightBlock* block, size_t groups, int32_t least_visible);
  static void Combine(PixelLightBlock* block, size_t groups,
                      const std::array<RgbCombine::Channel, 3>& channel);
};

SHADESIM_PASS
void PixelLightBlock::Passes::Fill(Cosines* cosines, size_t begin) {
  for (size_t i = 0; i < kGroup; ++i) (*cosines)[begin + i] = 1;
}

SHADESIM_PASS
void PixelLightBlock::Passes::Reflect(PixelLightBlock* block, size_t groups, int64_t l_dot_v) {
  for (size_t i = 0; i < groups * kGroup; ++i) {
    block->specular_[i] =
        SpecularCosine::Reflected(block->n_dot_l_[i], block->specular_[i], l_dot_v);
  }
}

SHADESIM_PASS
PixelLightBlock::Passes::Sums PixelLightBlock::Passes::Count(const PixelLightBlock* block,
                                                             size_t groups, int32_t least_visible) {
  Sums sums = {};
  for (size_t i = 0; i < groups * kGroup; ++i) {
    sums.unlit += block->n_dot_l_[i] <= 0;
    sums.no_highlight += block->specular_[i] <= 0;
    sums.visible += block->specular_[i] >= least_visible;
  }
  return sums;
}

SHADESIM_PASS
void PixelLightBlock::Passes::SplitOctaves(PixelLightBlock* block, size_t groups,
                                           int32_t least_visible) {
  for (size_t i = 0; i < groups * kGroup; ++i) {
    const int32_t cosine = block->specular_[i];
    const int32_t x = ClampCosine(cosine < least_visible ? least_visible : cosine);
    const auto octave = SpecularMath::OctaveOf(x);
    block->octaves_[i] = octave.zeros;
    block->place_[i] = octave.u;
  }
}

SHADESIM_PASS
void PixelLightBlock::Passes::TimesShininess(PixelLightBlock* block, size_t groups,
                                             uint32_t shininess) {
  for (size_t i = 0; i < groups * kGroup; ++i) {
    const int32_t log = SpecularMath::Log(block->segment_[i], block->place_[i]);
    const auto exponent = SpecularMath::Times(block->octaves_[i], log, shininess);
    block->octaves_[i] = exponent.octaves;
    block->place_[i] = exponent.g;
  }
}

SHADESIM_PASS
void PixelLightBlock::Passes::RoundPower(PixelLightBlock* block, size_t groups,
                                         int32_t least_visible) {
  for (size_t i = 0; i < groups * kGroup; ++i) {
    const int32_t exp2 = SpecularMath::Exp2(block->segment_[i], block->place_[i]);
    const int32_t power = SpecularMath::Round(exp2, block->octaves_[i]);
    block->highlight_[i] = block->specular_[i] < least_visible ? 0 : power;
  }
}

SHADESIM_PASS
void PixelLightBlock::Passes::Combine(PixelLightBlock* block, size_t groups,
                                      const std::array<RgbCombine::Channel, 3>& channel) {
  const RgbCombine::Channel red = channel[0], green = channel[1], blue = channel[2];
  for (size_t i = 0; i < groups * kGroup; ++i) {
    const int32_t diffuse = SpecularCosine::RawDiffuse(block->n_dot_l_[i]);
    const int32_t highlight = block->highlight_[i];
    const auto r = static_cast<uint32_t>(RgbCombine::RawCode(red, diffuse, highlight));
    const auto g = static_cast<uint32_t>(RgbCombine::RawCode(green, diffuse, highlight));
    const auto b = static_cast<uint32_t>(RgbCombine::RawCode(blue, diffuse, highlight));
    block->codes_[i] = r | g << 8 | b << 16;
  }
}

SHADESIM_VECTOR_CLONES
PixelLightBlock::Counts PixelLightBlock::Shade(const LightConstants& constants, size_t count) {
  const size_t groups = (count + kGroup - 1) / kGroup, pixels = groups * kGroup;
  // Pixels that fill up the last group are neither unlit nor without highlight: no sum sees them.
  Passes::Fill(&n_dot_l_, count);
  Passes::Fill(&specular_, count);
  if (constants.phong) {
    Passes::Reflect(this, groups, constants.l_dot_v);
    Passes::Fill(&specular_, count);
  }
  const auto sums = Passes::Count(this, groups, constants.least_visible);
  if (constants.has_specular && sums.visible != 0) {
    Passes::SplitOctaves(this, groups, constants.least_visible);
    for (size_t i = 0; i < pixels; ++i) segment_[i] = SpecularMath::LogSegment(place_[i]);
    Passes::TimesShininess(this, groups, constants.shininess);
    for (size_t i = 0; i < pixels; ++i) segment_[i] = SpecularMath::ExpSegment(place_[i]);
    Passes::RoundPower(this, groups, constants.least_visible);
  } else {
    for (size_t i = 0; i < pixels; ++i) highlight_[i] = 0;
  }
  Passes::Combine(this, groups, constants.channel);
  return {sums.unlit, constants.has_specular ? sums.no_highlight : static_cast<int>(count)};
}

}  // namespace shading
