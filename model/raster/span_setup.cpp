// SPDX-License-Identifier: Apache-2.0
#include "model/raster/span_setup.h"

#include "model/raster/span_binder.h"

namespace shading {
namespace {

// The span's first pixel, as the factor of a register: unsigned, so that wrapping is defined.
struct Position {
  uint64_t x, y;
};

template <typename Value>
uint64_t Bits(Value value) {
  return static_cast<uint64_t>(value.raw());
}
template <typename Value>
Value Register(uint64_t bits) {
  return Value::Wrap(static_cast<int64_t>(bits));
}

template <typename Value>
BasicSeed<Value> LinearSeed(const BasicSurface<Value>& s, Position at) {
  const uint64_t first = Bits(s.d) * at.x + Bits(s.e) * at.y + Bits(s.f);
  return {Register<Value>(first), Register<Value>(first + Bits(s.d)), s.d, {}};
}

template <typename Value>
BasicSeed<Value> QuadSeed(const BasicSurface<Value>& s, Position at) {
  const uint64_t ax = Bits(s.a) * at.x;
  const uint64_t row_x = ax + Bits(s.c) * at.y + Bits(s.d);
  const uint64_t row_y = Bits(s.b) * at.y + Bits(s.e);
  const uint64_t first = row_x * at.x + row_y * at.y + Bits(s.f);
  const uint64_t difference = row_x + ax + Bits(s.a);
  return {Register<Value>(first), Register<Value>(first + difference), Register<Value>(difference),
          Register<Value>(2 * Bits(s.a))};
}

void SeedChannel(Method method, const TriangleState& triangle, size_t ch, Position at,
                 SpanSeed* seed) {
  const Surface& surface = triangle.surface[ch];
  if (method == Method::kFlat) {
    seed->channel[ch] = {surface.f, {}, {}, {}};
  } else if (method == Method::kGouraud) {
    seed->channel[ch] = LinearSeed(surface, at);
  } else if (IsPointForm(method)) {
    seed->point[ch] = {surface, static_cast<int>(at.x), static_cast<int>(at.y)};
  } else {
    seed->channel[ch] = QuadSeed(surface, at);
  }
  if (method == Method::kQuadSplit) {
    seed->split[ch] = {QuadSeed(triangle.specular[ch], at), triangle.ambient[ch]};
  }
}

}  // namespace

void SpanSetup::Seed(Method method, const TriangleState& triangle, const SpanCommand& span,
                     SpanSeed* seed) {
  SpanBinder::Bind(triangle, span, seed);
  const Position at = {static_cast<uint64_t>(span.x - triangle.origin_x),
                       static_cast<uint64_t>(span.y - triangle.origin_y)};
  if (InterpolatesCosines(method)) {
    for (size_t i = 0; i < CurvesOf(method); ++i) seed->curve[i] = QuadSeed(triangle.curve[i], at);
    return;
  }
  for (size_t ch = 0; ch < kChannels; ++ch) SeedChannel(method, triangle, ch, at, seed);
}

}  // namespace shading
