// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "model/tlm/frame_registers.h"
#include "model/tlm/register_map_page.h"
#include "tb/stimulus/random_triangles.h"

namespace shading {
namespace {

TEST(RegisterMap, PageIsCurrent) {
  std::ifstream file(REGISTER_MAP_PAGE);
  std::ostringstream page;
  page << file.rdbuf();
  ASSERT_FALSE(page.str().empty()) << REGISTER_MAP_PAGE;
  EXPECT_TRUE(page.str() == RegisterMapPage())
      << "docs/register_map.md is stale: build/release/bin/register_map > docs/register_map.md";
}

TEST(RegisterMap, ResetValuesAreThoseOfTheTable) {
  RegisterFile registers;
  for (const Register& row : kRegisterMap) {
    EXPECT_EQ(registers.Get(row.offset), row.reset) << row.name;
    EXPECT_EQ(registers.Find(row.offset), &row);
    EXPECT_EQ(registers.Find(row.offset + kWordBytes * (row.words - 1)), &row);
  }
  EXPECT_EQ(registers.Find(0x07c), nullptr);
  EXPECT_EQ(registers.Find(kAddressSpace), nullptr);
}

TEST(RegisterMap, PacketsSurviveTheirWords) {
  const TriangleList list = tb::RandomTriangles(1, 2000);
  for (const TrianglePacket& packet : list.triangles) {
    TrianglePacket copy;
    PacketWords words = EncodePacket(packet);
    for (size_t i = 2; i < 18; i += 6) words[i] |= 0xff000000;  // bits that z does not have
    ASSERT_EQ(DecodePacket(words, 8, &copy), DeviceError::kNone);
    EXPECT_EQ(copy.x, packet.x);
    EXPECT_EQ(copy.y, packet.y);
    EXPECT_EQ(copy.z, packet.z);
    EXPECT_EQ(copy.n, packet.n);
    EXPECT_EQ(copy.material, packet.material);
  }
}

}  // namespace
}  // namespace shading
