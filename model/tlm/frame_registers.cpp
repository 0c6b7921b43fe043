// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/frame_registers.h"

#include <algorithm>

namespace shading {
namespace {

constexpr uint32_t kVertexWords = 6;

// |v|^2 has 44 fraction bits; within 2^-10 of unit length.
bool IsUnit(const Vector3& v) {
  constexpr int64_t kOne = int64_t{1} << NormalComponent::kFraction;
  constexpr int64_t kSlack = kOne >> 10;
  int64_t square = 0;
  for (const NormalComponent c : v) square += c.raw() * c.raw();
  return square >= (kOne - kSlack) * (kOne - kSlack) && square <= (kOne + kSlack) * (kOne + kSlack);
}

Vector3 DecodeVector(const uint32_t* words) {
  return {NormalComponent::Wrap(words[0]), NormalComponent::Wrap(words[1]),
          NormalComponent::Wrap(words[2])};
}

bool DecodeMaterial(const uint32_t* words, Material* material) {
  constexpr uint32_t kOne = 1u << Reflectance::kFraction;
  constexpr uint32_t kShininessOne = 1u << Shininess::kFraction;
  Rgb* const colors[] = {&material->ambient, &material->diffuse, &material->specular};
  for (Rgb* color : colors) {
    for (Reflectance& channel : *color) {
      if (*words > kOne) return false;
      channel = Reflectance::FromRaw(*words++);
    }
  }
  if (*words < kShininessOne || *words > 256 * kShininessOne) return false;
  material->shininess = Shininess::FromRaw(*words);
  return true;
}

DeviceError DecodeMaterials(const RegisterFile& registers, FrameState* state) {
  const uint32_t count = registers.Get(OffsetOf("MATERIAL_COUNT"));
  if (count > kMaxMaterials) return DeviceError::kMaterial;
  state->materials.resize(count);
  for (uint32_t i = 0; i < count; ++i) {
    const uint32_t offset = OffsetOf("MATERIALS") + i * kMaterialWords * kWordBytes;
    if (!DecodeMaterial(registers.data(offset), &state->materials[i])) {
      return DeviceError::kMaterial;
    }
  }
  return DeviceError::kNone;
}

bool PlaneFits(uint64_t base, uint32_t stride, const FrameState& state) {
  const auto width = static_cast<uint32_t>(state.width),
             height = static_cast<uint32_t>(state.height);
  return base % kWordBytes == 0 && stride % kWordBytes == 0 && stride >= kWordBytes * width &&
         base <= UINT64_MAX - uint64_t{stride} * height;
}

bool DecodeTarget(const RegisterFile& registers, const FrameState& state, FrameBuffer* target) {
  target->color_base = registers.Get64(OffsetOf("COLOR_BASE"));
  target->color_stride = registers.Get(OffsetOf("COLOR_STRIDE"));
  target->depth_test = registers.Get(OffsetOf("DEPTH_TEST")) != 0;
  target->depth_base = registers.Get64(OffsetOf("DEPTH_BASE"));
  target->depth_stride = registers.Get(OffsetOf("DEPTH_STRIDE"));
  return PlaneFits(target->color_base, target->color_stride, state) &&
         (!target->depth_test || PlaneFits(target->depth_base, target->depth_stride, state));
}

bool IsSize(uint32_t pixels) { return pixels >= 1 && pixels <= kMaxScreen; }

}  // namespace

DeviceError DecodeFrame(const RegisterFile& registers, FrameSetup* setup) {
  const uint32_t method = registers.Get(OffsetOf("METHOD"));
  if (method >= 32 || (MethodBits() >> method & 1) == 0) return DeviceError::kMethod;
  setup->method = static_cast<Method>(method);

  const uint32_t lighting = registers.Get(OffsetOf("LIGHTING"));
  const uint32_t cull = registers.Get(OffsetOf("CULL"));
  if (std::max({lighting, cull, registers.Get(OffsetOf("DEPTH_TEST"))}) > 1) {
    return DeviceError::kState;
  }
  const uint32_t tolerance = registers.Get(OffsetOf("TOLERANCE"));
  const uint32_t slope = registers.Get(OffsetOf("DEPTH_SLOPE"));
  if (tolerance > Tolerance::kMaxRaw || slope > DepthSlope::kMaxRaw) return DeviceError::kState;
  setup->tolerance = Tolerance::FromRaw(tolerance);
  FrameState& state = setup->state;
  state.lighting = static_cast<Lighting>(lighting);
  state.cull = static_cast<Cull>(cull);
  state.depth_slope = DepthSlope::FromRaw(slope);

  const uint32_t width = registers.Get(OffsetOf("WIDTH"));
  const uint32_t height = registers.Get(OffsetOf("HEIGHT"));
  if (!IsSize(width) || !IsSize(height)) return DeviceError::kSize;
  state.width = static_cast<int>(width);
  state.height = static_cast<int>(height);

  state.light = DecodeVector(registers.data(OffsetOf("LIGHT_X")));
  state.half = DecodeVector(registers.data(OffsetOf("HALF_X")));
  state.view = DecodeVector(registers.data(OffsetOf("VIEW_X")));
  if (!IsUnit(state.light) || !IsUnit(state.half) || !IsUnit(state.view)) {
    return DeviceError::kVector;
  }

  const DeviceError materials = DecodeMaterials(registers, &state);
  if (materials != DeviceError::kNone) return materials;
  return DecodeTarget(registers, state, &setup->target) ? DeviceError::kNone
                                                        : DeviceError::kFrameBuffer;
}

DeviceError DecodePacket(const PacketWords& words, int materials, TrianglePacket* packet) {
  for (size_t i = 0; i < 3; ++i) {
    const uint32_t* vertex = &words[i * kVertexWords];
    packet->x[i] = ScreenCoord::Wrap(vertex[0]);
    packet->y[i] = ScreenCoord::Wrap(vertex[1]);
    packet->z[i] = VertexDepth::FromRaw(vertex[2] & VertexDepth::kMaxRaw);
    packet->n[i] = DecodeVector(vertex + 3);
    if (!IsUnit(packet->n[i])) return DeviceError::kNormal;
  }
  if (words.back() >= static_cast<uint32_t>(materials)) return DeviceError::kMaterialIndex;
  packet->material = static_cast<int>(words.back());
  return DeviceError::kNone;
}

PacketWords EncodePacket(const TrianglePacket& packet) {
  PacketWords words;
  for (size_t i = 0; i < 3; ++i) {
    uint32_t* vertex = &words[i * kVertexWords];
    vertex[0] = static_cast<uint32_t>(packet.x[i].raw());
    vertex[1] = static_cast<uint32_t>(packet.y[i].raw());
    vertex[2] = static_cast<uint32_t>(packet.z[i].raw());
    for (size_t c = 0; c < 3; ++c) vertex[3 + c] = EncodeComponent(packet.n[i][c]);
  }
  words.back() = static_cast<uint32_t>(packet.material);
  return words;
}

MaterialEntry EncodeMaterial(const Material& material) {
  MaterialEntry entry = {};
  uint32_t* word = entry.data();
  for (const Rgb* color : {&material.ambient, &material.diffuse, &material.specular}) {
    for (const Reflectance channel : *color) *word++ = static_cast<uint32_t>(channel.raw());
  }
  *word = static_cast<uint32_t>(material.shininess.raw());
  return entry;
}

}  // namespace shading
