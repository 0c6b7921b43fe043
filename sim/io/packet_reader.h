// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>

#include "model/triangle_packet.h"

namespace shading::sim {

// Converts the lines of a packet file, see packet_file.h; knows where it is, for the error line.
class PacketReader {
 public:
  explicit PacketReader(const std::string& path) : path_(path) {}

  void NextLine() { ++line_; }
  FrameState ParseFrame(const std::string& text) const;
  TrianglePacket ParseTriangle(const std::string& text, const FrameState& frame) const;
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  using Json = nlohmann::json;

  // A JSON object with the required keys and, beyond them, only optional ones.
  Json ParseObject(const std::string& text, std::initializer_list<const char*> required,
                   std::initializer_list<const char*> optional) const;
  void CheckKeys(const Json& object, std::initializer_list<const char*> required,
                 std::initializer_list<const char*> optional) const;
  void CheckConstants(const Json& header) const;
  std::string Word(const Json& object, const char* key, const char* first,
                   const char* second) const;
  int64_t Integer(const Json& value, const char* key, int64_t low, int64_t high) const;
  double Real(const Json& value, const char* key, double low, double high) const;
  const Json& Three(const Json& value, const char* key) const;
  Vector3 UnitVector(const Json& header, const char* key) const;
  void CheckUnit(const Vector3& v, const char* key) const;
  Rgb Coefficients(const Json& material, const char* key) const;
  Material ParseMaterial(const Json& material) const;

  std::string path_;
  int64_t line_ = 0;
};

}  // namespace shading::sim
