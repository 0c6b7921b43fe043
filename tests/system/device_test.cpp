// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "tests/system/tlm_platform.h"

namespace shading::test {
namespace {

using sc_core::sc_time;
using sc_core::sc_time_stamp;

void OnBoth(const Body& body) {
  for (const Core core : kBothCores) EXPECT_TRUE(Simulate({core, {}, {}, {}}, {body}).finished);
}

// START with one register changed gives this error, draws nothing, and the next frame is good.
void ExpectStartError(std::string_view name, uint32_t value, DeviceError error) {
  SCOPED_TRACE(testing::Message() << name << " = " << value);
  OnBoth([&](Software* software) {
    TriangleList list = Empty(16, 8);
    list.triangles = {Cover(5), Cover(6)};
    ShadingDriver& driver = software->driver();
    driver.Start(list.frame, Method::kFlat, TargetFor(list.frame, true));
    driver.End();
    software->WaitIdle();
    EXPECT_EQ(driver.Error(), DeviceError::kNone);

    software->Set(name, value);
    software->Set("CONTROL", kControlStart);
    EXPECT_EQ(driver.Error(), error);
    for (const TrianglePacket& packet : list.triangles) driver.Push(packet);
    driver.End();
    software->WaitIdle();
    EXPECT_EQ(driver.Error(), error);
    EXPECT_EQ(driver.Counter("PIXELS"), 0u);

    software->Render(list, Method::kFlat, TargetFor(list.frame, false));
    EXPECT_EQ(driver.Error(), DeviceError::kNone);
    EXPECT_EQ(driver.Counter("PIXELS"), 2u * 16 * 8);
  });
}

TEST(ShadingDevice, RefusesBadFrameState) {
  ExpectStartError("METHOD", 31, DeviceError::kMethod);
  ExpectStartError("METHOD", 0x80000000, DeviceError::kMethod);
  ExpectStartError("LIGHTING", 2, DeviceError::kState);
  ExpectStartError("CULL", 2, DeviceError::kState);
  ExpectStartError("DEPTH_TEST", 2, DeviceError::kState);
  ExpectStartError("DEPTH_SLOPE", 1u << 24, DeviceError::kState);
  ExpectStartError("WIDTH", 0, DeviceError::kSize);
  ExpectStartError("HEIGHT", 4097, DeviceError::kSize);
  ExpectStartError("LIGHT_Z", 0, DeviceError::kVector);
  ExpectStartError("HALF_X", 0x200000, DeviceError::kVector);
  ExpectStartError("MATERIAL_COUNT", 257, DeviceError::kMaterial);
  ExpectStartError("MATERIAL_COUNT", 2, DeviceError::kMaterial);  // its shininess is 0
  ExpectStartError("MATERIALS", 0x10001, DeviceError::kMaterial);
  ExpectStartError("COLOR_BASE", 2, DeviceError::kFrameBuffer);
  ExpectStartError("COLOR_STRIDE", 60, DeviceError::kFrameBuffer);
  ExpectStartError("DEPTH_STRIDE", 66, DeviceError::kFrameBuffer);
}

TEST(ShadingDevice, SkipsBadTriangles) {
  OnBoth([](Software* software) {
    ShadingDriver& driver = software->driver();
    TriangleList list = Empty(16, 8);
    list.triangles = {Cover(5), Cover(6)};
    list.triangles[0].material = 1;
    software->Render(list, Method::kGouraud, TargetFor(list.frame, false));
    EXPECT_EQ(driver.Error(), DeviceError::kMaterialIndex);
    EXPECT_EQ(driver.Counter("TRIANGLES"), 1u);

    list.triangles[0].material = 0;
    list.triangles[0].n[2][0] = NormalComponent::Round(0.1);
    software->Render(list, Method::kGouraud, TargetFor(list.frame, false));
    EXPECT_EQ(driver.Error(), DeviceError::kNormal);
    EXPECT_EQ(driver.Counter("TRIANGLES"), 1u);

    list.triangles[1].material = 1;
    software->Render(list, Method::kGouraud, TargetFor(list.frame, false));
    EXPECT_EQ(driver.Error(), DeviceError::kNormal);  // the first one stays
    EXPECT_EQ(driver.Counter("TRIANGLES"), 0u);
  });
}

TEST(ShadingDevice, ReportsCommandsOutOfSequence) {
  OnBoth([](Software* software) {
    ShadingDriver& driver = software->driver();
    driver.End();
    EXPECT_EQ(driver.Error(), DeviceError::kSequence);
    EXPECT_FALSE(driver.Busy());
    const TriangleList list = Empty(16, 8);
    driver.Start(list.frame, Method::kFlat, TargetFor(list.frame, false));
    EXPECT_EQ(driver.Error(), DeviceError::kNone);
    EXPECT_TRUE(driver.Busy());
    software->Set("CONTROL", kControlStart);
    EXPECT_EQ(driver.Error(), DeviceError::kSequence);
    driver.End();
    software->WaitIdle();
  });
}

TEST(ShadingDevice, EndsTheFrameWhenTheBusFails) {
  OnBoth([](Software* software) {
    ShadingDriver& driver = software->driver();
    TriangleList list = Empty(16, 8);
    list.triangles = {Cover(5), Cover(4)};
    FrameBuffer target = TargetFor(list.frame, true);
    target.depth_base = Platform::kMemory - 3 * target.depth_stride;
    software->Clear(0xff);
    software->Render(list, Method::kFlat, target);
    EXPECT_EQ(driver.Error(), DeviceError::kBus);
    EXPECT_EQ(software->platform().memory.accesses(), 3u * 3);
  });
}

// The next frame's triangles fill the FIFO while one is shaded; one more waits, and is refused when
// the device is idle.
TEST(ShadingDevice, FullFifoIsRefusedWhenNobodyMakesRoom) {
  ShadingDevice::Options options;
  options.fifo_packets = 4;
  for (const Core core : kBothCores) {
    const Outcome outcome = Simulate(
        {core, options, {}, {}}, {[](Software* software) {
          ShadingDriver& driver = software->driver();
          TriangleList list = Empty(64, 64);
          list.triangles.assign(50, Cover(5));
          const FrameBuffer target = TargetFor(list.frame, false);
          driver.Start(list.frame, Method::kFlat, target);
          for (const TrianglePacket& packet : list.triangles) driver.Push(packet);
          driver.End();
          for (int i = 0; i < 4; ++i) driver.Push(Cover(6));
          EXPECT_EQ(StatusSpace(driver.Status()), 0u);
          EXPECT_TRUE(driver.Busy());

          PacketWords words = EncodePacket(Cover(7));
          EXPECT_EQ(software->Access(tlm::TLM_WRITE_COMMAND, OffsetOf("TRIANGLE_FIFO"),
                                     words.data(), 4 * kPacketWords),
                    tlm::TLM_GENERIC_ERROR_RESPONSE);
          EXPECT_FALSE(driver.Busy());  // it waited for the whole frame, then nobody made room
          EXPECT_GE(sc_time_stamp(), sc_time(50 * 64 * 64 * 10, sc_core::SC_NS));
          EXPECT_EQ(driver.Error(), DeviceError::kFifo);
          EXPECT_EQ(driver.Counter("TRIANGLES"), 50u);

          driver.Start(list.frame, Method::kFlat, target);
          driver.End();
          software->WaitIdle();
          EXPECT_EQ(driver.Counter("TRIANGLES"), 4u);
        }});
    EXPECT_TRUE(outcome.finished);
  }
}

// Software far ahead of simulation time fills the FIFO of an open frame: it waits for the device.
TEST(ShadingDevice, WriterOfAnOpenFrameWaitsForRoom) {
  ShadingDevice::Options options;
  options.fifo_packets = 4;
  for (const Core core : kBothCores) {
    const sc_time quantum(1, sc_core::SC_MS);
    const Outcome outcome =
        Simulate({core, options, quantum, {}}, {[](Software* software) {
                   ShadingDriver& driver = software->driver();
                   const TriangleList list = Empty(16, 8);
                   driver.Start(list.frame, Method::kFlat, TargetFor(list.frame, false));
                   for (int i = 0; i < 4; ++i) driver.Push(Cover(5));
                   EXPECT_EQ(sc_time_stamp(), sc_core::SC_ZERO_TIME);
                   EXPECT_EQ(StatusSpace(driver.Status()), 0u);
                   driver.Push(Cover(5));
                   EXPECT_GT(sc_time_stamp(), sc_core::SC_ZERO_TIME);
                   for (int i = 0; i < 45; ++i) driver.Push(Cover(5));
                   driver.End();
                   software->WaitIdle();
                   EXPECT_EQ(driver.Counter("TRIANGLES"), 50u);
                   EXPECT_EQ(driver.Error(), DeviceError::kNone);
                 }});
    EXPECT_TRUE(outcome.finished);
  }
}

// One process waits at the FIFO while a frame is shaded; another one empties it.
TEST(ShadingDevice, ResetLetsABlockedWriterGo) {
  ShadingDevice::Options options;
  options.fifo_packets = 2;
  for (const Core core : kBothCores) {
    sc_time pushed;
    const Body push = [&](Software* software) {
      software->Wait(sc_time(20, sc_core::SC_US));
      for (int i = 0; i < 3; ++i) software->driver().Push(Cover(6));
      pushed = sc_time_stamp();
    };
    const Body render = [&](Software* software) {
      TriangleList list = Empty(64, 64);
      list.triangles.assign(2, Cover(5));
      ShadingDriver& driver = software->driver();
      driver.Start(list.frame, Method::kFlat, TargetFor(list.frame, false));
      for (const TrianglePacket& packet : list.triangles) driver.Push(packet);
      driver.End();
      software->Wait(sc_time(40, sc_core::SC_US));
      EXPECT_EQ(pushed, sc_core::SC_ZERO_TIME);
      EXPECT_TRUE(driver.Busy());
      driver.Reset();
    };
    EXPECT_TRUE(Simulate({core, options, {}, {}}, {push, render}).finished);
    EXPECT_GT(pushed, sc_time(40, sc_core::SC_US));
    EXPECT_LT(pushed, sc_time(50, sc_core::SC_US));
  }
}

TEST(ShadingDevice, SoftResetEndsTheFrame) {
  for (const Core core : kBothCores) {
    const Outcome outcome =
        Simulate({core, {}, {}, {}}, {[](Software* software) {
                   ShadingDriver& driver = software->driver();
                   TriangleList list = Empty(64, 64);
                   list.triangles.assign(20, Cover(5));
                   driver.Start(list.frame, Method::kFlat, TargetFor(list.frame, false));
                   for (const TrianglePacket& packet : list.triangles) driver.Push(packet);
                   driver.End();
                   software->Wait(sc_time(10, sc_core::SC_US));
                   EXPECT_TRUE(driver.Busy());
                   driver.Push(Cover(6));
                   driver.Reset();
                   software->WaitIdle();
                   EXPECT_LT(sc_time_stamp(), sc_time(30, sc_core::SC_US));
                   EXPECT_EQ(software->Get("WIDTH"), 0u);
                   EXPECT_EQ(driver.Counter("PIXELS"), 0u);
                   EXPECT_EQ(driver.Status(), 64u << 8);
                   software->Render(list, Method::kFlat, TargetFor(list.frame, false));
                   EXPECT_EQ(driver.Counter("TRIANGLES"), 20u);
                 }});
    EXPECT_TRUE(outcome.finished);
  }
}

}  // namespace
}  // namespace shading::test
