// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm.h>
#include <tlm_utils/tlm_quantumkeeper.h>

#include <systemc>

#include "model/tlm/shading_driver.h"

namespace shading {

// Lets a ShadingDriver run in a SystemC thread and reach the registers through a socket, ahead of
// simulation time by at most a quantum. An error response is a SystemC error report.
class TlmRegisterBus : public ShadingDriver::Bus {
 public:
  using Transport = tlm::tlm_fw_transport_if<>;

  TlmRegisterBus(Transport* transport, uint64_t base, tlm_utils::tlm_quantumkeeper* keeper)
      : transport_(*transport), base_(base), keeper_(*keeper) {}

  void Write(uint32_t offset, const uint32_t* words, size_t count) override;
  uint32_t Read(uint32_t offset) override;

 private:
  void Access(tlm::tlm_command command, uint32_t offset, uint32_t* words, size_t count);

  Transport& transport_;
  uint64_t base_;
  tlm_utils::tlm_quantumkeeper& keeper_;
  tlm::tlm_generic_payload payload_;
};

}  // namespace shading
