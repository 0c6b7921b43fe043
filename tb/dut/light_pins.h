// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <type_traits>

#include "model/light/light_types.h"
#include "tb/bit_packer.h"

namespace shading::tb {

// Packed structs and arrays of light_pkg.sv at Verilated ports, words or scalars alike. The last
// declared field and element 0 of an array hold the lowest bits.

template <int kWords, typename Port>
void StoreBits(const BitPacker<kWords>& bits, Port& port) {
  if constexpr (std::is_integral_v<Port>) {
    static_assert(kWords <= 2, "a scalar port has up to 64 bits");
    uint32_t words[kWords];
    bits.Store(words);
    uint64_t value = words[0];
    if constexpr (kWords == 2) value |= static_cast<uint64_t>(words[1]) << 32;
    port = static_cast<Port>(value);
  } else {
    bits.Store(port);
  }
}

// `width` bits of a port from bit `position` on, at most 32.
template <typename Port>
uint32_t BitsOf(const Port& port, int position, int width) {
  const uint64_t mask = (uint64_t{1} << width) - 1;
  if constexpr (std::is_integral_v<Port>) {
    return static_cast<uint32_t>((static_cast<uint64_t>(port) >> position) & mask);
  } else {
    const int word = position / 32, shift = position % 32;
    uint64_t value = port[word];
    if (shift + width > 32) value |= static_cast<uint64_t>(port[word + 1]) << 32;
    return static_cast<uint32_t>((value >> shift) & mask);
  }
}

template <int kWords, int I, int F>
void PutAll(const std::array<S<I, F>, 3>& values, BitPacker<kWords>& bits) {
  for (const S<I, F> value : values) bits.Put(value);
}

template <int kWords>
void PutAll(const Rgb& values, BitPacker<kWords>& bits) {
  for (const Reflectance value : values) bits.Put(value.raw(), Reflectance::kWidth);
}

// A vector on its own port: direction_t or pixel_normal_t [2:0].
template <int I, int F, typename Port>
void DriveVector(const std::array<S<I, F>, 3>& vector, Port& port) {
  BitPacker<3> bits;
  PutAll(vector, bits);
  StoreBits(bits, port);
}

// light_t, 177 bits.
template <int kWords>
void PutLight(const LightState& light, BitPacker<kWords>& bits) {
  bits.Put(light.l_dot_v);
  PutAll(light.half_or_view, bits);
  PutAll(light.light, bits);
  bits.Put(light.lighting == Lighting::kPhong, 1);
}
template <typename Port>
void DriveLight(const LightState& light, Port& port) {
  BitPacker<6> bits;
  PutLight(light, bits);
  StoreBits(bits, port);
}

// material_t, 169 bits.
template <typename Port>
void DriveMaterial(const Material& material, Port& port) {
  BitPacker<6> bits;
  bits.Put(material.shininess.raw(), Shininess::kWidth);
  PutAll(material.specular, bits);
  PutAll(material.diffuse, bits);
  PutAll(material.ambient, bits);
  StoreBits(bits, port);
}

// cosines_t [Lanes-1:0], 64 bits each.
template <size_t kLanes, typename Port>
void DriveCosines(const std::array<LightCosines, kLanes>& lanes, Port& port) {
  BitPacker<static_cast<int>(2 * kLanes)> bits;
  for (const LightCosines& cosines : lanes) {
    bits.Put(cosines.n_dot_h_or_v);
    bits.Put(cosines.n_dot_l);
  }
  StoreBits(bits, port);
}

// code_t [Channels-1:0] of a lane.
template <typename Port>
PixelCodes ReadCodes(const Port& port, int lane) {
  const uint32_t rgb = BitsOf(port, 24 * lane, 24);
  return {static_cast<uint8_t>(rgb), static_cast<uint8_t>(rgb >> 8),
          static_cast<uint8_t>(rgb >> 16)};
}

}  // namespace shading::tb
