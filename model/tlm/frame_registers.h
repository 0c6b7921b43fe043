// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "model/tlm/register_file.h"
#include "model/triangle_packet.h"

namespace shading {

// Where pixels go. Row y of a plane starts at base + y stride; pixel x is its word x:
// colour as the bytes red, green, blue, 255; depth as U0.24, upper bits 0, in the host's byte
// order.
struct FrameBuffer {
  uint64_t color_base = 0;
  uint32_t color_stride = 0;  // bytes
  bool depth_test = false;
  uint64_t depth_base = 0;
  uint32_t depth_stride = 0;  // bytes
};

// What START takes over from the registers.
struct FrameSetup {
  FrameState state;
  Method method = Method::kFlat;
  Tolerance tolerance;
  FrameBuffer target;
};

using PacketWords = std::array<uint32_t, kPacketWords>;
using MaterialEntry = std::array<uint32_t, kMaterialWords>;

// Registers to frame; anything but kNone leaves `setup` incomplete.
DeviceError DecodeFrame(const RegisterFile& registers, FrameSetup* setup);

// Six words a vertex: x, y, z, normal x, y, z; then the material. Fields stand in the low bits;
// higher bits are ignored. A material or normal that the core does not accept is an error.
DeviceError DecodePacket(const PacketWords& words, int materials, TrianglePacket* packet);
PacketWords EncodePacket(const TrianglePacket& packet);

// Ambient, diffuse and specular red, green, blue as U1.16, shininess as U9.7, six unused words.
MaterialEntry EncodeMaterial(const Material& material);

inline uint32_t EncodeComponent(NormalComponent c) { return static_cast<uint32_t>(c.raw()); }

}  // namespace shading
