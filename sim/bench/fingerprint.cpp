// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/fingerprint.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <fstream>

namespace shading::sim {
namespace {

class Hash {
 public:
  void Add(const char* bytes, size_t count) {
    for (size_t i = 0; i < count; ++i) {
      value_ = (value_ ^ static_cast<uint8_t>(bytes[i])) * 0x100000001b3u;
    }
  }
  void Add(int64_t number) {
    for (int shift = 0; shift < 64; shift += 8) {
      value_ = (value_ ^ static_cast<uint8_t>(number >> shift)) * 0x100000001b3u;
    }
  }
  template <typename Numbers>
  void AddAll(const Numbers& numbers) {
    for (const auto& number : numbers) Add(number.raw());
  }
  std::string Text() const { return fmt::format("{:016x}", value_); }

 private:
  uint64_t value_ = 0xcbf29ce484222325u;
};

}  // namespace

std::string Fingerprint(const TriangleList& list) {
  Hash hash;
  const FrameState& frame = list.frame;
  for (const int64_t number :
       {int64_t{frame.width}, int64_t{frame.height}, static_cast<int64_t>(frame.lighting),
        static_cast<int64_t>(frame.cull)}) {
    hash.Add(number);
  }
  for (const Vector3* vector : {&frame.light, &frame.half, &frame.view}) hash.AddAll(*vector);
  for (const Material& material : frame.materials) {
    hash.AddAll(material.ambient);
    hash.AddAll(material.diffuse);
    hash.AddAll(material.specular);
    hash.Add(material.shininess.raw());
  }
  for (const TrianglePacket& packet : list.triangles) {
    hash.AddAll(packet.x);
    hash.AddAll(packet.y);
    hash.AddAll(packet.z);
    for (const Vector3& normal : packet.n) hash.AddAll(normal);
    hash.Add(packet.material);
  }
  return hash.Text();
}

std::string ProgramFingerprint() {
  std::ifstream file("/proc/self/exe", std::ios::binary);
  if (!file) return "unknown";
  Hash hash;
  std::array<char, 65536> block;
  while (file.read(block.data(), block.size()) || file.gcount() > 0) {
    hash.Add(block.data(), static_cast<size_t>(file.gcount()));
  }
  return hash.Text();
}

}  // namespace shading::sim
