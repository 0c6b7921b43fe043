// SPDX-License-Identifier: Apache-2.0
#include "tests/toggles/skip.h"

#include <gtest/gtest.h>

#include "tb/stimulus/random_triangles.h"
#include "tests/toggles/toggle_run.h"

namespace shading::test {
namespace {

// A list in which auto leaves out everything that it can.
TriangleList Skippable() {
  TriangleList list = tb::RandomTriangles(7, 60);
  for (size_t t = 0; t < 20; ++t) {
    TrianglePacket& packet = list.triangles[t];
    packet.n[1] = packet.n[2] = packet.n[0];
  }
  for (Material& material : list.frame.materials) {
    material.ambient[2] = material.diffuse[2] = material.specular[2] = Reflectance::FromRaw(0);
  }
  return list;
}

TEST(Skips, OffMeansOff) {
  const TriangleList list = Skippable();
  const auto counters = [&](Skip off) { return Trace(WorkWithout(list, kOneCode, off)).counters; };
  const Counters none = counters(Skip::kNone);
  EXPECT_GT(none.ambient, 0);
  EXPECT_GT(none.dark, 0);
  EXPECT_GT(none.unnormalised, 0);
  EXPECT_GT(none.black, 0);
  EXPECT_EQ(counters(Skip::kAmbient).ambient, 0);
  EXPECT_LT(counters(Skip::kConstant).constant, none.constant);
  EXPECT_EQ(counters(Skip::kDark).dark, 0);
  EXPECT_EQ(counters(Skip::kUnnormalised).unnormalised, 0);
  EXPECT_EQ(counters(Skip::kBlack).black, 0);
  EXPECT_GT(counters(Skip::kBackFaces).pixels, none.pixels);
  const Counters all = counters(Skip::kAll);
  EXPECT_EQ(all.ambient + all.constant + all.dark + all.unnormalised + all.black, 0);
}

TEST(Skips, NoneIsAuto) {
  const TriangleList list = Skippable();
  const FrameWork by_auto = WorkOf(list, Method::kAuto);
  const FrameWork same = WorkWithout(list, kOneCode, Skip::kNone);
  for (const Method method : kAllMethods) {
    const auto m = static_cast<size_t>(method);
    EXPECT_EQ(by_auto.share[m].spans, same.share[m].spans) << Name(method);
  }
  const TracedFrame a = Trace(by_auto), b = Trace(same);
  EXPECT_EQ(a.cycles, b.cycles);
  EXPECT_EQ(a.counters.ambient, b.counters.ambient);
  EXPECT_EQ(a.counters.dark, b.counters.dark);
  EXPECT_EQ(a.counters.black, b.counters.black);
  EXPECT_EQ(a.counters.unlit, b.counters.unlit);
}

}  // namespace
}  // namespace shading::test
