// SPDX-License-Identifier: Apache-2.0
#include "sim/io/packet_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "model/shading_types.h"

namespace shading::sim {
namespace {

constexpr const char* kFormat = "shadesim-triangles";

bool Contains(std::initializer_list<const char*> keys, const std::string& key) {
  return std::any_of(keys.begin(), keys.end(), [&](const char* k) { return key == k; });
}

}  // namespace

void PacketReader::Fail(const std::string& what) const {
  throw std::runtime_error(fmt::format("{}:{}: {}", path_, line_, what));
}

PacketReader::Json PacketReader::ParseObject(const std::string& text,
                                             std::initializer_list<const char*> required,
                                             std::initializer_list<const char*> optional) const {
  Json object;
  try {
    object = Json::parse(text);
  } catch (const Json::parse_error& error) {
    Fail(fmt::format("not JSON at column {}; write one JSON object a line", error.byte));
  } catch (const Json::exception&) {
    Fail("a number is too large for a double; stay in range");
  }
  CheckKeys(object, required, optional);
  return object;
}

void PacketReader::CheckKeys(const Json& object, std::initializer_list<const char*> required,
                             std::initializer_list<const char*> optional) const {
  if (!object.is_object()) Fail("not a JSON object; write {\"key\":value,...}");
  for (const char* key : required) {
    if (!object.contains(key)) Fail(fmt::format("\"{}\" is missing; add it", key));
  }
  for (const auto& item : object.items()) {
    if (Contains(required, item.key()) || Contains(optional, item.key())) continue;
    const std::string name = Json(item.key()).dump(-1, ' ', true, Json::error_handler_t::replace);
    Fail(fmt::format("unknown key {}; correct or remove it", name));
  }
}

int64_t PacketReader::Integer(const Json& value, const char* key, int64_t low, int64_t high) const {
  const bool too_large =
      value.is_number_unsigned() &&
      value.get<uint64_t>() > static_cast<uint64_t>(std::numeric_limits<int64_t>::max());
  if (value.is_number_integer() && !too_large) {
    const int64_t integer = value.get<int64_t>();
    if (integer >= low && integer <= high) return integer;
  }
  Fail(fmt::format("\"{}\" must hold whole numbers from {} to {}", key, low, high));
}

double PacketReader::Real(const Json& value, const char* key, double low, double high) const {
  if (value.is_number()) {
    const double real = value.get<double>();
    if (real >= low && real <= high) return real;
  }
  Fail(fmt::format("\"{}\" must hold numbers from {} to {}", key, low, high));
}

const PacketReader::Json& PacketReader::Three(const Json& value, const char* key) const {
  if (!value.is_array() || value.size() != 3) {
    Fail(fmt::format("\"{}\" must hold arrays of exactly 3 elements", key));
  }
  return value;
}

std::string PacketReader::Word(const Json& object, const char* key, const char* first,
                               const char* second) const {
  if (!object.contains(key)) return first;
  if (object[key] != first && object[key] != second) {
    Fail(fmt::format("\"{}\" must be \"{}\" or \"{}\"", key, first, second));
  }
  return object[key].get<std::string>();
}

void PacketReader::CheckUnit(const Vector3& v, const char* key) const {
  constexpr int kSquareFraction = 2 * NormalComponent::kFraction;
  int64_t square = 0;
  for (const NormalComponent c : v) square += c.raw() * c.raw();
  const int64_t error = square - (int64_t{1} << kSquareFraction);
  if (std::abs(error) > int64_t{1} << (kSquareFraction - 10)) {
    Fail(fmt::format("\"{}\" is not a unit vector: its squared length is {:.6g}; normalise it", key,
                     std::ldexp(static_cast<double>(square), -kSquareFraction)));
  }
}

Vector3 PacketReader::UnitVector(const Json& header, const char* key) const {
  Vector3 v;
  for (size_t c = 0; c < 3; ++c) {
    v[c] = NormalComponent::Round(Real(Three(header[key], key)[c], key, -1.001, 1.001));
  }
  CheckUnit(v, key);
  return v;
}

Rgb PacketReader::Coefficients(const Json& material, const char* key) const {
  Rgb rgb;
  for (size_t c = 0; c < 3; ++c) {
    rgb[c] = Reflectance::Round(Real(Three(material[key], key)[c], key, 0, 1));
  }
  return rgb;
}

Material PacketReader::ParseMaterial(const Json& material) const {
  CheckKeys(material, {"ambient", "diffuse", "specular", "shininess"}, {});
  return {Coefficients(material, "ambient"), Coefficients(material, "diffuse"),
          Coefficients(material, "specular"),
          Shininess::Round(Real(material["shininess"], "shininess", 1, 256))};
}

void PacketReader::CheckConstants(const Json& header) const {
  if (header["format"] != kFormat) {
    Fail(fmt::format("\"format\" must be \"{}\"; this is another kind of file", kFormat));
  }
  const std::initializer_list<std::pair<const char*, int>> constants = {
      {"version", 1},
      {"xy_fraction_bits", ScreenCoord::kFraction},
      {"z_fraction_bits", VertexDepth::kFraction},
      {"normal_fraction_bits", NormalComponent::kFraction}};
  for (const auto& [key, expected] : constants) {
    if (!header[key].is_number_integer() || header[key] != expected) {
      Fail(fmt::format("\"{}\" must be {}; write the file again for this version", key, expected));
    }
  }
}

FrameState PacketReader::ParseFrame(const std::string& text) const {
  const Json header =
      ParseObject(text,
                  {"format", "version", "width", "height", "xy_fraction_bits", "z_fraction_bits",
                   "normal_fraction_bits", "light", "half", "view", "materials"},
                  {"lighting", "cull", "depth_slope"});
  CheckConstants(header);
  FrameState frame;
  frame.width = static_cast<int>(Integer(header["width"], "width", 1, kMaxScreen));
  frame.height = static_cast<int>(Integer(header["height"], "height", 1, kMaxScreen));
  frame.light = UnitVector(header, "light");
  frame.half = UnitVector(header, "half");
  frame.view = UnitVector(header, "view");
  frame.lighting =
      Word(header, "lighting", "blinn", "phong") == "blinn" ? Lighting::kBlinn : Lighting::kPhong;
  frame.cull = Word(header, "cull", "back", "none") == "back" ? Cull::kBack : Cull::kNone;
  if (header.contains("depth_slope")) {
    frame.depth_slope = DepthSlope::FromRaw(
        Integer(header["depth_slope"], "depth_slope", 0, DepthSlope::kMaxRaw));
  }
  if (!header["materials"].is_array() || header["materials"].empty()) {
    Fail("\"materials\" must be an array with at least one material");
  }
  for (const Json& material : header["materials"]) {
    frame.materials.push_back(ParseMaterial(material));
  }
  return frame;
}

TrianglePacket PacketReader::ParseTriangle(const std::string& text, const FrameState& frame) const {
  constexpr int64_t kScreenLimit = int64_t{1} << (ScreenCoord::kWidth - 1);
  constexpr int64_t kUnit = int64_t{1} << NormalComponent::kFraction;
  const Json object = ParseObject(text, {"x", "y", "z", "n", "m"}, {});
  TrianglePacket packet;
  for (size_t k = 0; k < 3; ++k) {
    packet.x[k] = ScreenCoord::FromRaw(
        Integer(Three(object["x"], "x")[k], "x", -kScreenLimit, kScreenLimit - 1));
    packet.y[k] = ScreenCoord::FromRaw(
        Integer(Three(object["y"], "y")[k], "y", -kScreenLimit, kScreenLimit - 1));
    packet.z[k] =
        VertexDepth::FromRaw(Integer(Three(object["z"], "z")[k], "z", 0, VertexDepth::kMaxRaw));
    const Json& normal = Three(Three(object["n"], "n")[k], "n");
    for (size_t c = 0; c < 3; ++c) {
      packet.n[k][c] = NormalComponent::FromRaw(Integer(normal[c], "n", -2 * kUnit, 2 * kUnit - 1));
    }
    CheckUnit(packet.n[k], "n");
  }
  const auto last = static_cast<int64_t>(frame.materials.size()) - 1;
  packet.material = static_cast<int>(Integer(object["m"], "m", 0, last));
  return packet;
}

}  // namespace shading::sim
