// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/shading_types.h"
#include "tb/bit_packer.h"
#include "tb/dut/light_pins.h"

namespace shading::tb {

// Packed structs of shading_pkg.sv at Verilated ports. Fields go in from the lowest bits up, so the
// last declared field comes first, and channel 0 before channel 1.

inline constexpr int kCoordWidth = 12;
inline constexpr int kLengthWidth = 13;
inline constexpr int kMaterialWidth = 8;
inline constexpr int kMethodWidth = 5;
inline constexpr int kChannelsWidth = 3;
inline constexpr int kTriangleWords = 100;
inline constexpr int kSpanWords = 12;

template <typename Value, typename Bits>
void PutSurface(const BasicSurface<Value>& s, Bits& bits) {
  for (const Value value : {s.f, s.e, s.d, s.c, s.b, s.a}) bits.Put(value);
}

template <typename Bits>
void PutFootprint(const Footprint& footprint, Bits& bits) {
  for (const Margin value : footprint.margin_dx) bits.Put(value);
  for (const FootprintOffset& offset : footprint.offset) {
    for (const Margin value : offset.margin) bits.Put(value);
    for (const Quantity value : offset.normal) bits.Put(value);
  }
  bits.Put(static_cast<int64_t>(footprint.pattern), 2);
}

template <typename Bits>
void PutRange(const LightRange& range, Bits& bits) {
  for (const RangeCosine value :
       {range.specular_high, range.specular_low, range.n_dot_l_high, range.n_dot_l_low}) {
    bits.Put(value);
  }
  bits.Put(range.turn.raw(), Turn::kWidth);
}

template <typename Port>
void DriveLimit(const ChoiceLimit& limit, Port& port) {
  BitPacker<2> bits;
  bits.Put(limit.channels, kChannelsWidth);
  bits.Put(limit.below_full_dark, 1);
  bits.Put(limit.below_full, 1);
  bits.Put(limit.shininess.raw(), Shininess::kWidth);
  for (const Log value : {limit.shininess_log, limit.specular, limit.diffuse}) bits.Put(value);
  StoreBits(bits, port);
}

// choice_t, 10 bits.
template <typename Bits>
void PutChoice(const Choice& choice, Bits& bits) {
  bits.Put(choice.channels, kChannelsWidth);
  bits.Put(choice.ambient, 1);
  bits.Put(choice.dark, 1);
  bits.Put(static_cast<int64_t>(choice.method), kMethodWidth);
}

template <typename Port>
void DriveTriangle(const TriangleState& triangle, Port& port) {
  BitPacker<kTriangleWords> bits;
  for (const Surface& s : triangle.surface) PutSurface(s, bits);
  for (const Surface& s : triangle.specular) PutSurface(s, bits);
  for (const IntensityAcc value : triangle.ambient) bits.Put(value);
  for (const CosineSurface& s : triangle.curve) PutSurface(s, bits);
  PutFootprint(triangle.footprint, bits);
  bits.Put(triangle.limit.raw(), AngleLimit::kWidth);
  PutRange(triangle.range, bits);
  bits.Put(triangle.material, kMaterialWidth);
  bits.Put(triangle.dz_dx);
  bits.Put(triangle.origin_y, kCoordWidth);
  bits.Put(triangle.origin_x, kCoordWidth);
  bits.Store(port);
}

template <typename Port>
void DriveSpan(const SpanCommand& span, Port& port) {
  BitPacker<kSpanWords> bits;
  for (const Margin value : span.margin) bits.Put(value);
  for (const SpanNormal& normal : span.normal) PutAll(normal, bits);
  bits.Put(span.last, 1);
  bits.Put(span.z);
  bits.Put(span.length, kLengthWidth);
  bits.Put(span.y, kCoordWidth);
  bits.Put(span.x, kCoordWidth);
  bits.Store(port);
}

template <typename Port>
void DriveChannelSeed(const ChannelSeed& seed, Port& port) {
  BitPacker<5> bits;
  bits.Put(seed.curvature);
  bits.Put(seed.difference);
  bits.Put(seed.second);
  bits.Put(seed.first);
  bits.Store(port);
}

template <typename Port>
void DriveRun(const SpanSeed& seed, Port& port) {
  BitPacker<4> bits;
  bits.Put(seed.dz_dx);
  bits.Put(seed.z);
  bits.Put(seed.length, kLengthWidth);
  bits.Put(seed.y, kCoordWidth);
  bits.Put(seed.x, kCoordWidth);
  bits.Store(port);
}

template <typename Value, typename Bits>
BasicSeed<Value> TakeSeed(Bits& bits) {
  BasicSeed<Value> seed;
  seed.curvature = bits.template TakeSigned<Value>();
  seed.difference = bits.template TakeSigned<Value>();
  seed.second = bits.template TakeSigned<Value>();
  seed.first = bits.template TakeSigned<Value>();
  return seed;
}

template <typename Port>
SpanSeed ReadSeed(const Port& port) {
  BitReader<Port> bits(port);
  SpanSeed seed;
  for (ChannelSeed& channel : seed.channel) channel = TakeSeed<IntensityAcc>(bits);
  seed.dz_dx = bits.template TakeSigned<DepthAcc>();
  seed.z = bits.template TakeSigned<DepthAcc>();
  seed.length = static_cast<int>(bits.Take(kLengthWidth));
  seed.y = static_cast<int>(bits.Take(kCoordWidth));
  seed.x = static_cast<int>(bits.Take(kCoordWidth));
  return seed;
}

template <typename Port>
void DriveFrame(Method method, Tolerance tolerance, const LightState& light, Port& port) {
  BitPacker<7> bits;
  PutLight(light, bits);
  bits.Put(tolerance.raw(), Tolerance::kWidth);
  bits.Put(static_cast<int64_t>(method), kMethodWidth);
  bits.Store(port);
}

// quantity_seed_t [2:0][kLanes-1:0] and kappa_t.
template <int kLanes, typename QuantityPort, typename KappaPort>
NormalSeed ReadNormalSeed(const QuantityPort& quantity, const KappaPort& kappa) {
  NormalSeed seed;
  BitReader<QuantityPort> bits(quantity);
  for (auto& lanes : seed.quantity) {
    for (size_t lane = 0; lane < kLanes; ++lane) {
      lanes[lane].difference = bits.template TakeSigned<Quantity>();
      lanes[lane].first = bits.template TakeSigned<Quantity>();
    }
  }
  seed.kappa.exponent = static_cast<int>(kappa & 0xf);
  seed.kappa.mantissa = U<1, 28>::FromRaw(static_cast<int64_t>(kappa >> 4));
  return seed;
}

// pixel_t has 73 bits: last 0, b 8:1, g 16:9, r 24:17, z 48:25, y 60:49, x 72:61. Lane 0 is lowest.
inline constexpr int kPixelWidth = 73;

template <typename Port>
Pixel ReadPixel(const Port& port, int lane) {
  const int at = lane * kPixelWidth;
  const uint32_t color = BitsOf(port, at, 25);
  Pixel pixel;
  pixel.last = static_cast<uint8_t>(color & 1);
  pixel.b = static_cast<uint8_t>(color >> 1);
  pixel.g = static_cast<uint8_t>(color >> 9);
  pixel.r = static_cast<uint8_t>(color >> 17);
  pixel.z = BitsOf(port, at + 25, 24);
  pixel.y = static_cast<uint16_t>(BitsOf(port, at + 49, 12));
  pixel.x = static_cast<uint16_t>(BitsOf(port, at + 61, 12));
  return pixel;
}

}  // namespace shading::tb
