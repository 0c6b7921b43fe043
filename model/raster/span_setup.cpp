// SPDX-License-Identifier: Apache-2.0
#include "model/raster/span_setup.h"

#include "model/raster/span_binder.h"

namespace shading {
namespace {

// Arithmetic of a 36-bit register: unsigned, so that wrapping is defined.
uint64_t Bits(IntensityAcc value) { return static_cast<uint64_t>(value.raw()); }
IntensityAcc Register(uint64_t bits) { return IntensityAcc::Wrap(static_cast<int64_t>(bits)); }

ChannelSeed FlatSeed(const Surface& s, uint64_t /*x*/, uint64_t /*y*/) { return {s.f, {}, {}, {}}; }

ChannelSeed GouraudSeed(const Surface& s, uint64_t x, uint64_t y) {
  const uint64_t first = Bits(s.d) * x + Bits(s.e) * y + Bits(s.f);
  return {Register(first), {}, s.d, {}};
}

ChannelSeed QuadSeed(const Surface& s, uint64_t x, uint64_t y) {
  const uint64_t ax = Bits(s.a) * x;
  const uint64_t row_x = ax + Bits(s.c) * y + Bits(s.d);
  const uint64_t row_y = Bits(s.b) * y + Bits(s.e);
  const uint64_t first = row_x * x + row_y * y + Bits(s.f);
  const uint64_t difference = row_x + ax + Bits(s.a);
  return {Register(first), Register(first + difference), Register(difference),
          Register(2 * Bits(s.a))};
}

template <typename ChannelFunction>
void SeedChannels(const TriangleState& triangle, const SpanCommand& span,
                  const ChannelFunction& function, SpanSeed* seed) {
  const auto x = static_cast<uint64_t>(span.x - triangle.origin_x);
  const auto y = static_cast<uint64_t>(span.y - triangle.origin_y);
  for (size_t ch = 0; ch < kChannels; ++ch) {
    seed->channel[ch] = function(triangle.surface[ch], x, y);
  }
}

}  // namespace

void SpanSetup::Seed(Method method, const TriangleState& triangle, const SpanCommand& span,
                     SpanSeed* seed) {
  SpanBinder::Bind(triangle, span, seed);
  switch (method) {
    case Method::kFlat: return SeedChannels(triangle, span, FlatSeed, seed);
    case Method::kGouraud: return SeedChannels(triangle, span, GouraudSeed, seed);
    case Method::kQuad: return SeedChannels(triangle, span, QuadSeed, seed);
    default: return;
  }
}

}  // namespace shading
