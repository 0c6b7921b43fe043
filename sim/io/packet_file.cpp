// SPDX-License-Identifier: Apache-2.0
#include "sim/io/packet_file.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <fstream>
#include <stdexcept>

#include "sim/io/atomic_file.h"
#include "sim/io/packet_reader.h"

namespace shading::sim {
namespace {

// fmt writes the shortest decimal that reads back as the same double.
template <typename Fixed>
std::string Reals(const std::array<Fixed, 3>& v) {
  return fmt::format("[{},{},{}]", v[0].ToReal(), v[1].ToReal(), v[2].ToReal());
}

template <typename Fixed>
std::string Raws(const std::array<Fixed, 3>& v) {
  return fmt::format("[{},{},{}]", v[0].raw(), v[1].raw(), v[2].raw());
}

std::string Header(const FrameState& frame) {
  std::string materials;
  for (const Material& m : frame.materials) {
    materials += fmt::format("{}{{\"ambient\":{},\"diffuse\":{},\"specular\":{},\"shininess\":{}}}",
                             materials.empty() ? "" : ",", Reals(m.ambient), Reals(m.diffuse),
                             Reals(m.specular), m.shininess.ToReal());
  }
  return fmt::format(
      "{{\"format\":\"shadesim-triangles\",\"version\":1,\"width\":{},\"height\":{},"
      "\"xy_fraction_bits\":{},\"z_fraction_bits\":{},\"normal_fraction_bits\":{},"
      "\"lighting\":\"{}\",\"cull\":\"{}\",\"depth_slope\":{},\"light\":{},\"half\":{},\"view\":{},"
      "\"materials\":[{}]}}\n",
      frame.width, frame.height, ScreenCoord::kFraction, VertexDepth::kFraction,
      NormalComponent::kFraction, frame.lighting == Lighting::kBlinn ? "blinn" : "phong",
      frame.cull == Cull::kBack ? "back" : "none", frame.depth_slope.raw(), Reals(frame.light),
      Reals(frame.half), Reals(frame.view), materials);
}

bool IsBlank(const std::string& line) { return line.find_first_not_of(" \t\r") == line.npos; }

}  // namespace

TriangleList ReadPackets(const std::string& path) {
  if (std::filesystem::is_directory(path)) {
    throw std::runtime_error(fmt::format("{}: is a folder; give a file of packets", path));
  }
  if (!std::filesystem::exists(path)) {
    throw std::runtime_error(fmt::format("{}: no such file; check the path", path));
  }
  std::ifstream file(path);
  PacketReader reader(path);
  TriangleList list;
  std::string line;
  bool have_header = false;
  while (std::getline(file, line)) {
    reader.NextLine();
    if (IsBlank(line)) continue;
    if (have_header) {
      list.triangles.push_back(reader.ParseTriangle(line, list.frame));
    } else {
      list.frame = reader.ParseFrame(line);
      have_header = true;
    }
  }
  if (file.bad() || !file.eof()) {
    throw std::runtime_error(fmt::format("{}: cannot be read; check its permissions", path));
  }
  if (!have_header) {
    reader.NextLine();
    reader.Fail("the file is empty; line 1 must be the header");
  }
  return list;
}

void WritePackets(const std::string& path, const TriangleList& list) {
  AtomicFile file(path);
  file.stream() << Header(list.frame);
  for (const TrianglePacket& t : list.triangles) {
    fmt::print(file.stream(), "{{\"x\":{},\"y\":{},\"z\":{},\"n\":[{},{},{}],\"m\":{}}}\n",
               Raws(t.x), Raws(t.y), Raws(t.z), Raws(t.n[0]), Raws(t.n[1]), Raws(t.n[2]),
               t.material);
  }
  file.Commit();
}

}  // namespace shading::sim
