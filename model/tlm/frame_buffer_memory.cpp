// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/frame_buffer_memory.h"

#include <algorithm>
#include <cstring>

namespace shading {
namespace {

// Bytes that an access touches: streaming repeats the first streaming_width of them.
uint64_t Footprint(const tlm::tlm_generic_payload& payload) {
  return std::min(payload.get_data_length(), payload.get_streaming_width());
}

bool Fits(uint64_t address, uint64_t length, uint64_t size) {
  return address <= size && length <= size - address;
}

}  // namespace

FrameBufferMemory::FrameBufferMemory(const sc_core::sc_module_name& name, uint64_t bytes,
                                     const sc_core::sc_time& latency)
    : sc_module(name),
      unit_socket("unit_socket"),
      host_socket("host_socket"),
      bytes_(bytes),
      latency_(latency) {
  Register(&unit_socket);
  Register(&host_socket);
}

template <typename AnySocket>
void FrameBufferMemory::Register(AnySocket* socket) {
  socket->register_b_transport(this, &FrameBufferMemory::Transport);
  socket->register_transport_dbg(this, &FrameBufferMemory::DebugTransport);
  socket->register_get_direct_mem_ptr(this, &FrameBufferMemory::DirectMemory);
}

void FrameBufferMemory::Transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  payload.set_dmi_allowed(true);
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
  if (payload.get_command() == tlm::TLM_IGNORE_COMMAND) return;
  if (!payload.get_data_ptr() || payload.get_data_length() == 0 ||
      payload.get_streaming_width() == 0) {
    payload.set_response_status(tlm::TLM_BURST_ERROR_RESPONSE);
  } else if (payload.get_byte_enable_ptr() && payload.get_byte_enable_length() == 0) {
    payload.set_response_status(tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE);
  } else if (!Fits(payload.get_address(), Footprint(payload), bytes_.size())) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
  } else {
    Copy(payload);
    delay += latency_;
    ++accesses_;
  }
}

void FrameBufferMemory::Copy(const tlm::tlm_generic_payload& payload) {
  uint8_t* memory = &bytes_[payload.get_address()];
  uint8_t* data = payload.get_data_ptr();
  const unsigned length = payload.get_data_length();
  const unsigned width = payload.get_streaming_width();
  const uint8_t* enable = payload.get_byte_enable_ptr();
  if (!enable && width >= length) {
    if (payload.is_read()) {
      std::memcpy(data, memory, length);
    } else {
      std::memcpy(memory, data, length);
    }
    return;
  }
  for (unsigned i = 0; i < length; ++i) {
    if (enable && enable[i % payload.get_byte_enable_length()] != TLM_BYTE_ENABLED) continue;
    uint8_t& byte = memory[i % width];
    if (payload.is_read()) {
      data[i] = byte;
    } else {
      byte = data[i];
    }
  }
}

// Byte enables and streaming width don't apply; what lies beyond the end is not transferred.
unsigned FrameBufferMemory::DebugTransport(tlm::tlm_generic_payload& payload) {
  const uint64_t address = payload.get_address();
  if (!payload.get_data_ptr() || address >= bytes_.size()) return 0;
  const auto length =
      static_cast<unsigned>(std::min<uint64_t>(payload.get_data_length(), bytes_.size() - address));
  if (payload.is_read()) {
    std::memcpy(payload.get_data_ptr(), &bytes_[address], length);
  } else if (payload.is_write()) {
    std::memcpy(&bytes_[address], payload.get_data_ptr(), length);
  } else {
    return 0;
  }
  return length;
}

bool FrameBufferMemory::DirectMemory(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& dmi) {
  dmi.init();
  dmi.set_start_address(0);
  dmi.set_end_address(bytes_.empty() ? 0 : bytes_.size() - 1);
  if (payload.get_address() >= bytes_.size()) return false;
  dmi.set_dmi_ptr(bytes_.data());
  dmi.set_read_latency(latency_);
  dmi.set_write_latency(latency_);
  dmi.allow_read_write();
  return true;
}

}  // namespace shading
