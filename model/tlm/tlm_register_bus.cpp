// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/tlm_register_bus.h"

#include <algorithm>

namespace shading {

void TlmRegisterBus::Write(uint32_t offset, const uint32_t* words, size_t count) {
  // The payload has no pointer to constant data; a target does not change what is written.
  Access(tlm::TLM_WRITE_COMMAND, offset, const_cast<uint32_t*>(words), count);
}

uint32_t TlmRegisterBus::Read(uint32_t offset) {
  uint32_t word = 0;
  Access(tlm::TLM_READ_COMMAND, offset, &word, 1);
  return word;
}

void TlmRegisterBus::Access(tlm::tlm_command command, uint32_t offset, uint32_t* words,
                            size_t count) {
  const auto bytes = static_cast<unsigned>(count * kWordBytes);
  payload_.set_command(command);
  payload_.set_address(base_ + offset);
  payload_.set_data_ptr(reinterpret_cast<uint8_t*>(words));
  payload_.set_data_length(bytes);
  payload_.set_streaming_width(bytes);
  payload_.set_byte_enable_ptr(nullptr);
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);

  sc_core::sc_time delay = keeper_.get_local_time();
  transport_.b_transport(payload_, delay);
  keeper_.set(delay);
  if (payload_.is_response_error()) {
    SC_REPORT_ERROR("shadesim", payload_.get_response_string().c_str());
  }
  if (keeper_.need_sync()) keeper_.sync();
}

}  // namespace shading
