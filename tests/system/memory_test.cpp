// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numeric>

#include "tests/system/tlm_platform.h"

namespace shading::test {
namespace {

// An access to the memory's host socket.
struct MemoryAccess {
  tlm::tlm_generic_payload payload;
  std::vector<uint8_t> data;

  MemoryAccess(tlm::tlm_command command, uint64_t address, unsigned length) : data(length) {
    std::iota(data.begin(), data.end(), uint8_t{1});
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(data.data());
    payload.set_data_length(length);
    payload.set_streaming_width(length);
  }
  tlm::tlm_response_status Do(Software* software) {
    sc_core::sc_time delay;
    software->platform().memory_socket->b_transport(payload, delay);
    return payload.get_response_status();
  }
};

void WithMemory(const Body& body) {
  EXPECT_TRUE(Simulate({Core::kModel, {}, {}, {}}, {body}).finished);
}

TEST(FrameBufferMemory, HonoursByteEnables) {
  WithMemory([](Software* software) {
    std::vector<uint8_t> enable = {TLM_BYTE_DISABLED, TLM_BYTE_ENABLED, TLM_BYTE_ENABLED};
    MemoryAccess write(tlm::TLM_WRITE_COMMAND, 101, 8);
    write.payload.set_byte_enable_ptr(enable.data());
    write.payload.set_byte_enable_length(3);
    EXPECT_EQ(write.Do(software), tlm::TLM_OK_RESPONSE);
    MemoryAccess read(tlm::TLM_READ_COMMAND, 100, 10);
    EXPECT_EQ(read.Do(software), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(read.data, (std::vector<uint8_t>{0, 0, 2, 3, 0, 5, 6, 0, 8, 0}));
  });
}

TEST(FrameBufferMemory, HonoursStreamingWidth) {
  WithMemory([](Software* software) {
    MemoryAccess write(tlm::TLM_WRITE_COMMAND, Platform::kMemory - 4, 8);
    write.payload.set_streaming_width(4);
    EXPECT_EQ(write.Do(software), tlm::TLM_OK_RESPONSE);
    MemoryAccess read(tlm::TLM_READ_COMMAND, Platform::kMemory - 4, 6);
    read.payload.set_streaming_width(4);
    EXPECT_EQ(read.Do(software), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(read.data, (std::vector<uint8_t>{5, 6, 7, 8, 5, 6}));
  });
}

TEST(FrameBufferMemory, RefusesWhatDoesNotFit) {
  WithMemory([](Software* software) {
    MemoryAccess beyond(tlm::TLM_WRITE_COMMAND, Platform::kMemory - 4, 8);
    EXPECT_EQ(beyond.Do(software), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    MemoryAccess wrapping(tlm::TLM_READ_COMMAND, UINT64_MAX - 1, 8);
    EXPECT_EQ(wrapping.Do(software), tlm::TLM_ADDRESS_ERROR_RESPONSE);
    MemoryAccess empty(tlm::TLM_READ_COMMAND, 0, 0);
    EXPECT_EQ(empty.Do(software), tlm::TLM_BURST_ERROR_RESPONSE);
    EXPECT_EQ(software->platform().memory.accesses(), 0u);
  });
}

TEST(FrameBufferMemory, GivesDebugAndDirectAccess) {
  WithMemory([](Software* software) {
    auto& socket = software->platform().memory_socket;
    MemoryAccess write(tlm::TLM_WRITE_COMMAND, Platform::kMemory - 4, 8);
    EXPECT_EQ(socket->transport_dbg(write.payload), 4u);
    MemoryAccess beyond(tlm::TLM_READ_COMMAND, Platform::kMemory, 4);
    EXPECT_EQ(socket->transport_dbg(beyond.payload), 0u);

    tlm::tlm_dmi dmi;
    EXPECT_FALSE(socket->get_direct_mem_ptr(beyond.payload, dmi));
    ASSERT_TRUE(socket->get_direct_mem_ptr(write.payload, dmi));
    EXPECT_TRUE(dmi.is_read_write_allowed());
    EXPECT_EQ(dmi.get_start_address(), 0u);
    EXPECT_EQ(dmi.get_end_address(), Platform::kMemory - 1);
    EXPECT_EQ(dmi.get_dmi_ptr()[Platform::kMemory - 3], 2);
    dmi.get_dmi_ptr()[5] = 77;
    MemoryAccess read(tlm::TLM_READ_COMMAND, 5, 1);
    EXPECT_EQ(read.Do(software), tlm::TLM_OK_RESPONSE);
    EXPECT_EQ(read.data[0], 77);
    EXPECT_TRUE(read.payload.is_dmi_allowed());
  });
}

}  // namespace
}  // namespace shading::test
