// SPDX-License-Identifier: Apache-2.0
#include "sim/io/packet_file.h"

#include "sim/scene/builtin.h"
#include "sim/scene/camera.h"
#include "tests/sim/disk_limit.h"
#include "tests/sim/test_files.h"

namespace shading::sim {
namespace {

using PacketFileTest = FileTest;

const char kHeader[] =
    R"({"format":"shadesim-triangles","version":1,"width":64,"height":48,"xy_fraction_bits":8,)"
    R"("z_fraction_bits":24,"normal_fraction_bits":22,"light":[0,0,1],"half":[0.6,0,0.8],)"
    R"("view":[0,0,1],"materials":[{"ambient":[0,0,0],"diffuse":[0.5,0.5,0.5],)"
    R"("specular":[0,0,1],"shininess":32}]})";
const char kTriangle[] = R"({"x":[0,256,512],"y":[0,-256,2097151],"z":[0,1,16777215],)"
                         R"("n":[[0,0,4194304],[0,4194304,0],[-4194304,0,0]],"m":0})";

std::string Replace(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void ExpectEqual(const FrameState& a, const FrameState& b) {
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.light, b.light);
  EXPECT_EQ(a.half, b.half);
  EXPECT_EQ(a.view, b.view);
  EXPECT_EQ(a.lighting, b.lighting);
  EXPECT_EQ(a.cull, b.cull);
  EXPECT_EQ(a.depth_slope, b.depth_slope);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (size_t i = 0; i < a.materials.size(); ++i) {
    EXPECT_EQ(a.materials[i].ambient, b.materials[i].ambient);
    EXPECT_EQ(a.materials[i].diffuse, b.materials[i].diffuse);
    EXPECT_EQ(a.materials[i].specular, b.materials[i].specular);
    EXPECT_EQ(a.materials[i].shininess, b.materials[i].shininess);
  }
}

void ExpectEqual(const TriangleList& a, const TriangleList& b) {
  ExpectEqual(a.frame, b.frame);
  ASSERT_EQ(a.triangles.size(), b.triangles.size());
  for (size_t i = 0; i < a.triangles.size(); ++i) {
    ASSERT_EQ(a.triangles[i].x, b.triangles[i].x);
    ASSERT_EQ(a.triangles[i].y, b.triangles[i].y);
    ASSERT_EQ(a.triangles[i].z, b.triangles[i].z);
    ASSERT_EQ(a.triangles[i].n, b.triangles[i].n);
    ASSERT_EQ(a.triangles[i].material, b.triangles[i].material);
  }
}

TEST_F(PacketFileTest, BuiltinsReadBackIdentical) {
  for (const BuiltinScene& entry : kBuiltinScenes) {
    for (const bool other : {false, true}) {
      ViewOptions options;
      options.yaw = 33;
      options.pitch = -21;
      options.perspective = other;
      options.lighting = other ? Lighting::kPhong : Lighting::kBlinn;
      options.cull = other ? Cull::kNone : Cull::kBack;
      Scene scene = MakeBuiltin(entry.name);
      scene.materials[0].shininess = 37.123;
      const TriangleList list = Project(scene, options);
      WritePackets(Path("a.jsonl"), list);
      ExpectEqual(ReadPackets(Path("a.jsonl")), list);
      EXPECT_EQ(FileCount(), 1);
    }
  }
}

TEST_F(PacketFileTest, ReadsTheFormat) {
  const TriangleList list =
      ReadPackets(Write("a.jsonl", std::string(kHeader) + "\r\n\n" + kTriangle + "\n"));
  EXPECT_EQ(list.frame.width, 64);
  EXPECT_EQ(list.frame.lighting, Lighting::kBlinn);
  EXPECT_EQ(list.frame.cull, Cull::kBack);
  EXPECT_EQ(list.frame.half[0], NormalComponent::Round(0.6));
  EXPECT_EQ(list.frame.materials[0].specular[2].ToReal(), 1);
  ASSERT_EQ(list.triangles.size(), 1u);
  EXPECT_EQ(list.triangles[0].y[2].raw(), 2097151);
  EXPECT_EQ(list.triangles[0].z[2].raw(), 16777215);
  EXPECT_EQ(list.triangles[0].n[2][0].raw(), -4194304);
}

TEST_F(PacketFileTest, NoTrianglesIsAFrame) {
  EXPECT_TRUE(ReadPackets(Write("a.jsonl", kHeader)).triangles.empty());
}

struct Fault {
  const char *from, *to, *message;
};

TEST_F(PacketFileTest, HeaderFaults) {
  const Fault faults[] = {
      {"shadesim-triangles", "other", "\"format\" must be"},
      {"\"version\":1", "\"version\":2", "\"version\" must be 1"},
      {"\"version\":1", "\"version\":\"1\"", "\"version\" must be 1"},
      {"\"xy_fraction_bits\":8", "\"xy_fraction_bits\":4", "\"xy_fraction_bits\" must be 8"},
      {"\"z_fraction_bits\":24", "\"z_fraction_bits\":16", "\"z_fraction_bits\" must be 24"},
      {"normal_fraction_bits\":22", "normal_fraction_bits\":14", "\"normal_fraction_bits\" must"},
      {"\"width\":64,", "", "\"width\" is missing; add it"},
      {"\"width\":64", "\"width\":0", "\"width\" must hold whole numbers from 1 to 4096"},
      {"\"width\":64", "\"width\":64.0", "\"width\" must hold whole numbers"},
      {"\"height\":48", "\"height\":4097", "\"height\" must hold"},
      {"\"light\":[0,0,1]", "\"light\":[0,0]", "\"light\" must hold arrays of exactly 3"},
      {"\"light\":[0,0,1]", "\"light\":[0,0,0]", "\"light\" is not a unit vector"},
      {"\"light\":[0,0,1]", "\"light\":[0,0,9]", "\"light\" must hold numbers"},
      {"\"light\":[0,0,1]", "\"light\":[0,0,NaN]", "not JSON at column"},
      {"\"light\":[0,0,1]", "\"light\":[0,0,1e999]", "too large"},
      {"[0.6,0,0.8]", "[0.6,0,0.81]", "\"half\" is not a unit vector"},
      {"\"view\":[0,0,1]", "\"view\":\"up\"", "\"view\" must hold arrays"},
      {"[0.5,0.5,0.5]", "[0.5,1.5,0.5]", "\"diffuse\" must hold numbers from 0 to 1"},
      {"[0.5,0.5,0.5]", "[0.5,null,0.5]", "\"diffuse\" must hold numbers"},
      {"\"shininess\":32", "\"shininess\":0.5", "\"shininess\" must hold numbers from 1 to 256"},
      {"\"shininess\":32", "\"shine\":32", "\"shininess\" is missing"},
      {"\"version\":1", "\"version\":1,\"cull\":\"front\"", "\"cull\" must be \"back\" or"},
      {"\"version\":1", "\"version\":1,\"lighting\":1", "\"lighting\" must be"},
      {"\"version\":1", "\"version\":1,\"li\\nghting\":1", "unknown key \"li\\nghting\""},
      {"\"height\":48,", "\"height\":48", "not JSON at column"},
  };
  for (const Fault& f : faults) {
    const std::string path = Write("a.jsonl", Replace(kHeader, f.from, f.to) + "\n" + kTriangle);
    ExpectError([&] { ReadPackets(path); }, "a.jsonl:1: ");
    ExpectError([&] { ReadPackets(path); }, f.message);
  }
  std::string none = kHeader;
  none = none.substr(0, none.find("[{")) + "[]}";
  ExpectError([&] { ReadPackets(Write("a.jsonl", none)); }, "at least one material");
}

TEST_F(PacketFileTest, TriangleFaults) {
  const Fault faults[] = {
      {"\"x\":[0,256,512]", "\"x\":[0,256]", "\"x\" must hold arrays of exactly 3"},
      {"\"x\":[0,256,512]", "\"x\":[0,256,512.5]", "\"x\" must hold whole numbers"},
      {"2097151", "2097152", "\"y\" must hold whole numbers from -2097152 to 2097151"},
      {"\"x\":[0", "\"x\":[-2097153", "\"x\" must hold"},
      {"\"z\":[0", "\"z\":[-1", "\"z\" must hold whole numbers from 0 to 16777215"},
      {"16777215", "16777216", "\"z\" must hold"},
      {"\"x\":[0", "\"x\":[18446744073709551615", "\"x\" must hold"},  // -1 if it wrapped
      {"[0,4194304,0]", "[0,4100000,0]", "\"n\" is not a unit vector: its squared length is 0.95"},
      {"[0,4194304,0]", "[0,4194304]", "\"n\" must hold arrays of exactly 3"},
      {"[0,4194304,0]", "[0,4194304,\"0\"]", "\"n\" must hold whole numbers"},
      {"[0,4194304,0]", "[0,9194304,0]", "\"n\" must hold whole numbers"},
      {"\"m\":0", "\"m\":1", "\"m\" must hold whole numbers from 0 to 0"},
      {"\"m\":0", "\"m\":-1", "\"m\" must hold"},
      {",\"m\":0", "", "\"m\" is missing"},
      {"\"m\":0", "\"m\":0,\"k\":0", "unknown key \"k\"; correct or remove it"},
      {"\"m\":0}", "\"m\":0", "not JSON at column"},
      {"\"m\":0}", "\"m\":0} {}", "not JSON at column"},
  };
  for (const Fault& f : faults) {
    const std::string path = Write("a.jsonl", std::string(kHeader) + "\n" + kTriangle + "\n" +
                                                  Replace(kTriangle, f.from, f.to) + "\n");
    ExpectError([&] { ReadPackets(path); }, "a.jsonl:3: ");
    ExpectError([&] { ReadPackets(path); }, f.message);
  }
  ExpectError([&] { ReadPackets(Write("a.jsonl", std::string(kHeader) + "\n[1]\n")); },
              "a.jsonl:2: not a JSON object");
}

TEST_F(PacketFileTest, UnitLengthWithinTheTolerance) {
  // |n|^2 = (1 + e)^2 with e just inside and just outside 2^-11.
  const auto with = [&](int n) {
    return Write("a.jsonl",
                 std::string(kHeader) + "\n" + Replace(kTriangle, "4194304", std::to_string(n)));
  };
  EXPECT_NO_THROW(ReadPackets(with(4194304 + 2047)));
  EXPECT_NO_THROW(ReadPackets(with(4194304 - 2048)));
  ExpectError([&] { ReadPackets(with(4194304 + 2049)); }, "not a unit vector");
  ExpectError([&] { ReadPackets(with(4194304 - 2050)); }, "not a unit vector");
}

TEST_F(PacketFileTest, BadFiles) {
  ExpectError([&] { ReadPackets(Path("")); }, "is a folder; give a file of packets");
  ExpectError([&] { ReadPackets(Path("none.jsonl")); }, "none.jsonl: no such file");
  ExpectError([&] { ReadPackets(Write("a.jsonl", "")); }, "a.jsonl:1: the file is empty");
  ExpectError([&] { ReadPackets(Write("a.jsonl", std::string("\0\xff\xfe", 3))); },
              "a.jsonl:1: not JSON at column 1");
}

TEST_F(PacketFileTest, FullDisk) {
  const TriangleList list = Project(MakeBuiltin("sphere"), {});
  if (HasFullDevice()) {
    ExpectError([&] { WritePackets("/dev/full", list); },
                "/dev/full: could not be written in full");
  }
  Write("a.jsonl", "old");
  {
    const DiskLimit limit(4096);
    ExpectError([&] { WritePackets(Path("a.jsonl"), list); }, "could not be written in full");
  }
  EXPECT_EQ(Read("a.jsonl"), "old");
  EXPECT_EQ(FileCount(), 1);
}

}  // namespace
}  // namespace shading::sim
