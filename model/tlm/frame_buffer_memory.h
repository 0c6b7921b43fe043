// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm.h>
#include <tlm_utils/simple_target_socket.h>

#include <cstdint>
#include <systemc>
#include <vector>

namespace shading {

// Plain dual-port memory from address 0: any length and alignment, byte enables, streaming width,
// debug access, direct memory interface. Each access takes `latency`.
class FrameBufferMemory : public sc_core::sc_module {
 public:
  using Socket = tlm_utils::simple_target_socket<FrameBufferMemory>;
  using OptionalSocket = tlm_utils::simple_target_socket_optional<FrameBufferMemory>;

  Socket unit_socket;          // for the shading unit
  OptionalSocket host_socket;  // for software or a display; may stay unbound

  FrameBufferMemory(const sc_core::sc_module_name& name, uint64_t bytes,
                    const sc_core::sc_time& latency = sc_core::SC_ZERO_TIME);

  const std::vector<uint8_t>& bytes() const { return bytes_; }
  uint64_t accesses() const { return accesses_; }

 private:
  void Transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned DebugTransport(tlm::tlm_generic_payload& payload);
  bool DirectMemory(tlm::tlm_generic_payload& payload, tlm::tlm_dmi& dmi);
  void Copy(const tlm::tlm_generic_payload& payload);

  template <typename AnySocket>
  void Register(AnySocket* socket);

  std::vector<uint8_t> bytes_;
  sc_core::sc_time latency_;
  uint64_t accesses_ = 0;
};

}  // namespace shading
