// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm.h>
#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <tlm_utils/tlm_quantumkeeper.h>

#include <deque>
#include <memory>
#include <systemc>

#include "model/flow_pattern.h"
#include "model/raster/front_end.h"
#include "model/shading_unit.h"
#include "model/tlm/register_file.h"
#include "model/tlm/span_writer.h"

namespace shading {

// The shading unit as a device of a virtual platform: registers, triangle FIFO and frame buffer
// master around a core that derived classes provide. Loosely timed, temporally decoupled.
//
// START takes over the frame state; the front end then collects triangles as they come, in no time;
// END lets the core shade the frame, with the exact cycles of the hardware. See docs/tlm.md.
class ShadingDevice : public sc_core::sc_module {
 public:
  struct Options {
    sc_core::sc_time clock_period{10, sc_core::SC_NS};
    uint32_t fifo_packets = 64;                // 1..255
    FlowPattern sink = FlowPattern::Always();  // cycles in which the core may emit a pixel
  };

  tlm_utils::simple_target_socket<ShadingDevice> target_socket;        // registers
  tlm_utils::simple_initiator_socket<ShadingDevice> initiator_socket;  // frame buffer

  ShadingDevice(const sc_core::sc_module_name& name, const Options& options);

 protected:
  struct CoreResult {
    Counters counters;
    int64_t cycles = 0;  // from the acceptance of the frame until the core is empty
    bool failed = false;
  };

  // Shades one frame in a SystemC thread: every span to `sink`, until it returns false.
  virtual CoreResult Shade(const FrameWork& work, const FlowPattern& pixel_flow,
                           SpanSink* sink) = 0;

 private:
  enum class Phase { kIdle, kOpen, kShading };

  void Transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  unsigned DebugTransport(tlm::tlm_generic_payload& payload);
  uint32_t ReadWord(uint32_t offset) const;
  bool WriteWord(uint32_t offset, uint32_t value, sc_core::sc_time* delay);
  void Control(uint32_t command, const sc_core::sc_time& delay);
  void Start();
  void SoftReset();
  bool Push(sc_core::sc_time* delay);

  void Run();
  void Collect();
  void ShadeFrame();
  void SetCounters(const CoreResult& result, uint64_t written);
  void GoIdle();
  void Fail(DeviceError error);

  Options options_;
  RegisterFile registers_;
  PacketWords staging_ = {};
  std::deque<PacketWords> fifo_;
  Phase phase_ = Phase::kIdle;
  DeviceError error_ = DeviceError::kNone;
  bool discard_ = false;          // START found the frame state in error
  bool ended_ = false;            // END was written
  size_t remaining_ = 0;          // packets in the FIFO that belong to the ended frame
  sc_core::sc_time frame_start_;  // when END was written
  sc_core::sc_event work_, space_;
  FrameSetup setup_;
  std::unique_ptr<FrontEnd> front_end_;
  FrameWork frame_work_;
  uint32_t packets_ = 0;          // of this frame, so far
  SpanWriter* writer_ = nullptr;  // while shading
  tlm_utils::tlm_quantumkeeper keeper_;
};

}  // namespace shading
