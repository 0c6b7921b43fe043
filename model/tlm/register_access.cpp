// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/register_access.h"

namespace shading {

tlm::tlm_response_status CheckAccess(const tlm::tlm_generic_payload& payload,
                                     const RegisterFile& registers) {
  if (!payload.is_write() && !payload.is_read()) return tlm::TLM_OK_RESPONSE;
  const uint64_t address = payload.get_address();
  const unsigned length = payload.get_data_length();
  if (payload.get_byte_enable_ptr()) return tlm::TLM_BYTE_ENABLE_ERROR_RESPONSE;
  if (!payload.get_data_ptr()) return tlm::TLM_GENERIC_ERROR_RESPONSE;
  if (length == 0 || length % kWordBytes != 0 || payload.get_streaming_width() < length) {
    return tlm::TLM_BURST_ERROR_RESPONSE;
  }
  if (address % kWordBytes != 0 || address >= kAddressSpace || length > kAddressSpace) {
    return tlm::TLM_ADDRESS_ERROR_RESPONSE;
  }
  const Access forbidden = payload.is_write() ? Access::kRead : Access::kWrite;
  for (unsigned i = 0; i < length; i += kWordBytes) {
    const Register* row = registers.Find(address + i);
    if (!row) return tlm::TLM_ADDRESS_ERROR_RESPONSE;
    if (row->access == forbidden) return tlm::TLM_COMMAND_ERROR_RESPONSE;
  }
  return tlm::TLM_OK_RESPONSE;
}

}  // namespace shading
