// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm_utils/simple_initiator_socket.h>

#include <array>
#include <functional>
#include <memory>
#include <systemc>
#include <vector>

#include "model/tlm/frame_buffer_memory.h"
#include "model/tlm/shading_device.h"
#include "model/tlm/tlm_register_bus.h"

namespace shading::test {

enum class Core { kModel, kRtl };
inline constexpr std::array<Core, 2> kBothCores = {Core::kModel, Core::kRtl};

struct Setup {
  Core core = Core::kModel;
  ShadingDevice::Options options;
  sc_core::sc_time quantum;
  sc_core::sc_time memory_latency;
};

// Between device and memory: notes when each burst arrives, with its annotated delay.
class BusMonitor : public sc_core::sc_module {
 public:
  explicit BusMonitor(const sc_core::sc_module_name& name);

  tlm_utils::simple_target_socket<BusMonitor> device_side;
  tlm_utils::simple_initiator_socket<BusMonitor> memory_side;
  std::vector<sc_core::sc_time> arrivals;

 private:
  void Transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
};

// Software, device, monitor and memory.
class Platform : public sc_core::sc_module {
 public:
  static constexpr uint64_t kMemory = 1 << 21;  // bytes

  Platform(const sc_core::sc_module_name& name, const Setup& setup);

  tlm_utils::simple_initiator_socket<Platform> device_socket, memory_socket;
  std::unique_ptr<ShadingDevice> device;
  BusMonitor monitor;
  FrameBufferMemory memory;
};

// One thread of software on a platform.
class Software {
 public:
  explicit Software(Platform* platform);

  // A whole frame, up to idle, polled every 100 ns.
  void Render(const TriangleList& list, Method method, const FrameBuffer& target);
  void WaitIdle();
  void Wait(const sc_core::sc_time& time);

  // Register access with everything that a payload can say; `words` may be null.
  tlm::tlm_response_status Access(tlm::tlm_command command, uint64_t address, uint32_t* words,
                                  unsigned bytes);
  // The register's word, behind the driver's back.
  void Set(std::string_view name, uint32_t value);
  uint32_t Get(std::string_view name) { return bus_.Read(OffsetOf(name)); }

  // Fills memory through the debug interface.
  void Clear(uint8_t byte);

  ShadingDriver& driver() { return driver_; }
  Platform& platform() { return platform_; }

 private:
  Platform& platform_;
  tlm_utils::tlm_quantumkeeper keeper_;
  TlmRegisterBus bus_;
  ShadingDriver driver_;
};

using Body = std::function<void(Software*)>;

// What is left of a simulation.
struct Outcome {
  std::vector<uint8_t> memory;
  bool finished = false;  // every body returned
};

// Runs each body in a SystemC thread, in a simulation of its own, until nothing happens any more.
Outcome Simulate(const Setup& setup, const std::vector<Body>& bodies);

// Colour at 0, depth behind it, some bytes between the rows.
FrameBuffer TargetFor(const FrameState& frame, bool depth_test);

// A frame that is lit from the front, with one white material.
TriangleList Empty(int width, int height);
// Covers the screen, at a depth of raw U0.24.
TrianglePacket Cover(int64_t depth);

}  // namespace shading::test
