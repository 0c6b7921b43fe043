// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/surface_shader.h"

#include <array>

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
#include "model/raster/pixel_words.h"

namespace shading {
namespace {

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

void SurfaceShader::Shade(Method method, const SpanSeed& seed, Tolerance tolerance, int lanes,
                          Pixel* pixels) {
  switch (method) {
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
          [&](size_t ch) { return LaneSegments(seed.channel[ch], tolerance, lanes); },
          pixels);
    case Method::kQuadSplit:
      return ShadeSpan(
          seed, [&](size_t ch) { return QuadSplit(seed.channel[ch], seed.split[ch]); }, pixels);
    default: return;
  }
}

}  // namespace shading
