// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>

#include "tests/system/tlm_platform.h"

namespace shading::test {
namespace {

constexpr auto kRead = tlm::TLM_READ_COMMAND;
constexpr auto kWrite = tlm::TLM_WRITE_COMMAND;

void OnBoth(const Body& body) {
  for (const Core core : kBothCores) EXPECT_TRUE(Simulate({core, {}, {}, {}}, {body}).finished);
}

TEST(RegisterAccess, AnswersWrongAccessesWithTheRightError) {
  OnBoth([](Software* software) {
    uint32_t words[32] = {};
    const auto access = [&](tlm::tlm_command command, uint64_t address, unsigned bytes) {
      return software->Access(command, address, words, bytes);
    };
    EXPECT_EQ(access(kRead, OffsetOf("ID"), 4), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(words[0], 0x44414853u);
    EXPECT_EQ(access(kWrite, OffsetOf("WIDTH"), 8), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(access(kRead, 0x07c, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, kAddressSpace, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, kAddressSpace - 4, 8), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, UINT64_MAX - 3, 8), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, uint64_t{1} << 32, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, OffsetOf("WIDTH") + 2, 4), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, OffsetOf("WIDTH"), 2), tlm::TLM_BURST_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, OffsetOf("WIDTH"), 0), tlm::TLM_BURST_ERROR_RESPONSE);
    EXPECT_EQ(access(kWrite, OffsetOf("ID"), 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
    EXPECT_EQ(access(kWrite, OffsetOf("PIXELS"), 8), tlm::TLM_COMMAND_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, OffsetOf("CONTROL"), 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
    EXPECT_EQ(access(kRead, OffsetOf("TRIANGLE_FIFO"), 4), tlm::TLM_COMMAND_ERROR_RESPONSE);
    EXPECT_EQ(access(tlm::TLM_IGNORE_COMMAND, 1, 3), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(software->Access(kRead, 0, nullptr, 4), tlm::TLM_GENERIC_ERROR_RESPONSE);
  });
}

TEST(RegisterAccess, RefusedBurstChangesNothing) {
  OnBoth([](Software* software) {
    uint32_t words[] = {5, 6};
    EXPECT_EQ(software->Access(kWrite, OffsetOf("DEPTH_SLOPE"), words, 8),
              tlm::TLM_ADDRESS_ERROR_RESPONSE);
    EXPECT_EQ(software->Get("DEPTH_SLOPE"), 0u);
  });
}

TEST(RegisterAccess, HasNoByteEnablesNoStreamingAndNoDirectMemory) {
  OnBoth([](Software* software) {
    uint32_t word = 0;
    uint8_t enable = TLM_BYTE_ENABLED;
    tlm::tlm_generic_payload payload;
    payload.set_read();
    payload.set_address(OffsetOf("VERSION"));
    payload.set_data_ptr(reinterpret_cast<uint8_t*>(&word));
    payload.set_data_length(4);
    payload.set_streaming_width(4);
    payload.set_byte_enable_ptr(&enable);
    payload.set_byte_enable_length(1);
    sc_core::sc_time delay;
    auto& socket = software->platform().device_socket;
    socket->b_transport(payload, delay);
    EXPECT_EQ(payload.get_response_status(), tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
    payload.set_byte_enable_ptr(nullptr);
    payload.set_streaming_width(2);
    socket->b_transport(payload, delay);
    EXPECT_EQ(payload.get_response_status(), tlm::TLM_BURST_ERROR_RESPONSE);
    EXPECT_EQ(delay, sc_core::SC_ZERO_TIME);

    EXPECT_EQ(socket->transport_dbg(payload), 0u);
    payload.set_streaming_width(4);
    EXPECT_EQ(socket->transport_dbg(payload), 4u);
    EXPECT_EQ(word, RegisterNamed("VERSION").reset);
    payload.set_write();
    EXPECT_EQ(socket->transport_dbg(payload), 0u);
    tlm::tlm_dmi dmi;
    EXPECT_FALSE(socket->get_direct_mem_ptr(payload, dmi));
  });
}

TEST(RegisterAccess, TakesOneClockPeriodAWord) {
  ShadingDevice::Options options;
  options.clock_period = sc_core::sc_time(3, sc_core::SC_NS);
  Simulate({Core::kModel, options, {}, {}}, {[](Software* software) {
             software->driver().Push(Cover(0));
             EXPECT_EQ(sc_core::sc_time_stamp(), sc_core::sc_time(57, sc_core::SC_NS));
           }});
}

// Whatever the words say, the device answers and stays usable.
TEST(RegisterAccess, SurvivesRandomRegistersAndPackets) {
  OnBoth([](Software* software) {
    std::mt19937 random(7);
    const auto word = [&] { return static_cast<uint32_t>(random()) >> (random() & 31); };
    for (int round = 0; round < 300; ++round) {
      software->Set("CONTROL", kControlReset);
      const TriangleList list = Empty(64, 48);
      software->driver().Start(list.frame, Method::kQuad, TargetFor(list.frame, true));
      for (int i = 0; i < 20; ++i) {
        PacketWords words = EncodePacket(Cover(word() & 0xffffff));
        for (int k = 0; k < 3; ++k) words[random() % words.size()] = word();
        software->Access(kWrite, OffsetOf("TRIANGLE_FIFO"), words.data(), 4 * kPacketWords);
        const Register& row = kRegisterMap[random() % kRegisterMap.size()];
        if (row.access == Access::kReadWrite) software->Set(row.name, word());
      }
      software->Set("CONTROL", kControlEnd | (random() & kControlStart));
      software->WaitIdle();
      software->Set("CONTROL", kControlStart | kControlEnd);
      software->WaitIdle();
    }
  });
}

}  // namespace
}  // namespace shading::test
