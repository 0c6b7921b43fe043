// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tlm.h>
#include <tlm_utils/tlm_quantumkeeper.h>

#include <cstdint>
#include <systemc>
#include <vector>

#include "model/shading_types.h"
#include "model/tlm/frame_registers.h"

namespace shading {

// Takes the spans of a frame from a core, in order.
class SpanSink {
 public:
  virtual ~SpanSink() = default;
  // `last_cycle`: in which the span's last pixel left, counted from the acceptance of the frame.
  // May wait. Returns false to end the frame early.
  virtual bool Accept(const Pixel* pixels, int length, int64_t last_cycle) = 0;
};

// Writes spans to the frame buffer: one burst per span and plane, issued at the local time at which
// the span's last pixel left. With the depth test the depth row is read first and bursts carry byte
// enables; a span that is hidden everywhere is not written.
class SpanWriter : public SpanSink {
 public:
  using Bus = tlm::tlm_fw_transport_if<>;

  // The frame was accepted at `start`; one cycle takes `period`.
  SpanWriter(const FrameBuffer& target, const sc_core::sc_time& start,
             const sc_core::sc_time& period, Bus* bus, tlm_utils::tlm_quantumkeeper* keeper);

  bool Accept(const Pixel* pixels, int length, int64_t last_cycle) override;

  // Ends the frame early, from another process.
  void Stop() { stopped_ = true; }
  // Advances local time to the end of the last burst and synchronises.
  void Finish();

  bool stopped() const { return stopped_; }
  bool bus_failed() const { return bus_failed_; }
  uint64_t written() const { return written_; }  // pixels that passed the depth test

 private:
  sc_core::sc_time TimeOf(int64_t cycle) const;
  void SetLocalTime(const sc_core::sc_time& time);
  void WriteSpan(const Pixel* pixels, size_t length, sc_core::sc_time* delay);
  size_t DepthTest(const Pixel* pixels, size_t length);
  void Transport(tlm::tlm_command command, uint64_t address, uint8_t* data, size_t length,
                 bool masked, sc_core::sc_time* delay);

  FrameBuffer target_;
  sc_core::sc_time start_, period_;
  sc_core::sc_time completed_;  // of the latest burst
  Bus& bus_;
  tlm_utils::tlm_quantumkeeper& keeper_;
  tlm::tlm_generic_payload payload_;
  std::vector<uint8_t> color_, enable_;  // bytes of one span
  std::vector<uint32_t> depth_;
  bool stopped_ = false;
  bool bus_failed_ = false;
  uint64_t written_ = 0;
};

}  // namespace shading
