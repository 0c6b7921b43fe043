// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/shading_driver.h"

#include <algorithm>

namespace shading {

void ShadingDriver::Start(const FrameState& frame, Method method, const FrameBuffer& target) {
  WriteWord(OffsetOf("METHOD"), static_cast<uint32_t>(method));
  WriteWord(OffsetOf("LIGHTING"), static_cast<uint32_t>(frame.lighting));
  WriteWord(OffsetOf("CULL"), static_cast<uint32_t>(frame.cull));
  WriteWord(OffsetOf("WIDTH"), static_cast<uint32_t>(frame.width));
  WriteWord(OffsetOf("HEIGHT"), static_cast<uint32_t>(frame.height));
  WriteVector(OffsetOf("LIGHT_X"), frame.light);
  WriteVector(OffsetOf("HALF_X"), frame.half);
  WriteVector(OffsetOf("VIEW_X"), frame.view);
  WriteWord(OffsetOf("DEPTH_SLOPE"), static_cast<uint32_t>(frame.depth_slope.raw()));

  WriteWord(OffsetOf("MATERIAL_COUNT"), static_cast<uint32_t>(frame.materials.size()));
  // A longer list is refused as a whole by START.
  const auto count = std::min<size_t>(frame.materials.size(), kMaxMaterials);
  uint32_t offset = OffsetOf("MATERIALS");
  for (size_t i = 0; i < count; ++i, offset += kMaterialWords * kWordBytes) {
    const MaterialEntry entry = EncodeMaterial(frame.materials[i]);
    bus_.Write(offset, entry.data(), entry.size());
  }

  WritePlane(OffsetOf("COLOR_BASE"), target.color_base, OffsetOf("COLOR_STRIDE"),
             target.color_stride);
  WriteWord(OffsetOf("DEPTH_TEST"), target.depth_test ? 1 : 0);
  WritePlane(OffsetOf("DEPTH_BASE"), target.depth_base, OffsetOf("DEPTH_STRIDE"),
             target.depth_stride);
  WriteWord(OffsetOf("CONTROL"), kControlStart);
}

void ShadingDriver::Push(const TrianglePacket& packet) {
  const PacketWords words = EncodePacket(packet);
  bus_.Write(OffsetOf("TRIANGLE_FIFO"), words.data(), words.size());
}

uint64_t ShadingDriver::Counter(std::string_view name) {
  const uint32_t offset = OffsetOf(name);
  const uint64_t low = bus_.Read(offset);
  return low | static_cast<uint64_t>(bus_.Read(offset + kWordBytes)) << 32;
}

void ShadingDriver::WriteVector(uint32_t offset, const Vector3& vector) {
  const std::array<uint32_t, 3> words = {EncodeComponent(vector[0]), EncodeComponent(vector[1]),
                                         EncodeComponent(vector[2])};
  bus_.Write(offset, words.data(), words.size());
}

void ShadingDriver::WritePlane(uint32_t base_offset, uint64_t base, uint32_t stride_offset,
                               uint32_t stride) {
  const std::array<uint32_t, 2> words = {static_cast<uint32_t>(base),
                                         static_cast<uint32_t>(base >> 32)};
  bus_.Write(base_offset, words.data(), words.size());
  WriteWord(stride_offset, stride);
}

}  // namespace shading
