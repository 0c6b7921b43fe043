// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/shading_device.h"

#include <algorithm>
#include <cstring>

#include "model/tlm/register_access.h"

namespace shading {
namespace {

using sc_core::sc_time;

constexpr uint32_t kControl = OffsetOf("CONTROL");
constexpr uint32_t kStatus = OffsetOf("STATUS");
constexpr uint32_t kFifo = OffsetOf("TRIANGLE_FIFO");
constexpr uint32_t kFifoLast = kFifo + (kPacketWords - 1) * kWordBytes;

}  // namespace

ShadingDevice::ShadingDevice(const sc_core::sc_module_name& name, const Options& options)
    : sc_module(name),
      target_socket("target_socket"),
      initiator_socket("initiator_socket"),
      options_(options) {
  if (options_.fifo_packets < 1 || options_.fifo_packets > kMaxFifo) {
    SC_REPORT_FATAL("shadesim", "the FIFO holds 1 to 255 packets");
  }
  target_socket.register_b_transport(this, &ShadingDevice::Transport);
  target_socket.register_transport_dbg(this, &ShadingDevice::DebugTransport);
  SC_HAS_PROCESS(ShadingDevice);
  SC_THREAD(Run);
}

/////////////////////
// Register access //
/////////////////////

void ShadingDevice::Transport(tlm::tlm_generic_payload& payload, sc_time& delay) {
  payload.set_dmi_allowed(false);
  payload.set_response_status(CheckAccess(payload, registers_));
  if (payload.is_response_error() || payload.get_command() == tlm::TLM_IGNORE_COMMAND) return;

  const auto offset = static_cast<uint32_t>(payload.get_address());
  uint8_t* data = payload.get_data_ptr();
  for (uint32_t i = 0; i < payload.get_data_length(); i += kWordBytes) {
    delay += options_.clock_period;
    uint32_t word;
    if (payload.is_read()) {
      word = ReadWord(offset + i);
      std::memcpy(data + i, &word, kWordBytes);
    } else {
      std::memcpy(&word, data + i, kWordBytes);
      if (!WriteWord(offset + i, word, &delay)) {
        payload.set_response_status(tlm::TLM_GENERIC_ERROR_RESPONSE);
      }
    }
  }
}

// Reads without side effects or time; nothing is written.
unsigned ShadingDevice::DebugTransport(tlm::tlm_generic_payload& payload) {
  if (!payload.is_read() || CheckAccess(payload, registers_) != tlm::TLM_OK_RESPONSE) return 0;
  for (uint32_t i = 0; i < payload.get_data_length(); i += kWordBytes) {
    const uint32_t word = ReadWord(static_cast<uint32_t>(payload.get_address()) + i);
    std::memcpy(payload.get_data_ptr() + i, &word, kWordBytes);
  }
  return payload.get_data_length();
}

uint32_t ShadingDevice::ReadWord(uint32_t offset) const {
  if (offset != kStatus) return registers_.Get(offset);
  const auto space = options_.fifo_packets - static_cast<uint32_t>(fifo_.size());
  return (phase_ == Phase::kIdle ? 0 : kStatusBusy) |
         (phase_ == Phase::kShading ? kStatusShading : 0) | space << 8 |
         static_cast<uint32_t>(error_) << 16;
}

bool ShadingDevice::WriteWord(uint32_t offset, uint32_t value, sc_time* delay) {
  if (offset == kControl) {
    Control(value, *delay);
  } else if (offset < kFifo || offset > kFifoLast) {
    registers_.Set(offset, value);
  } else {
    staging_[(offset - kFifo) / kWordBytes] = value;
    return offset != kFifoLast || Push(delay);
  }
  return true;
}

void ShadingDevice::Control(uint32_t command, const sc_time& delay) {
  if (command & kControlReset) return SoftReset();
  if (command & kControlStart) {
    if (phase_ == Phase::kIdle) {
      Start();
    } else {
      Fail(DeviceError::kSequence);
    }
  }
  if (command & kControlEnd) {
    if (phase_ != Phase::kOpen || ended_) return Fail(DeviceError::kSequence);
    ended_ = true;
    remaining_ = fifo_.size();
    frame_start_ = sc_core::sc_time_stamp() + delay;
    work_.notify(sc_core::SC_ZERO_TIME);
  }
}

void ShadingDevice::Start() {
  setup_ = FrameSetup();
  error_ = DecodeFrame(registers_, &setup_);
  discard_ = error_ != DeviceError::kNone;
  frame_work_ = FrameWork();
  if (!discard_) {
    front_end_ = std::make_unique<FrontEnd>(
        setup_.state, setup_.method, FrontEndOptions{setup_.tolerance, Subdivide::kNever});
    frame_work_ = front_end_->Begin();
  }
  packets_ = 0;
  ended_ = false;
  phase_ = Phase::kOpen;
  work_.notify(sc_core::SC_ZERO_TIME);
}

void ShadingDevice::SoftReset() {
  registers_.Reset();
  staging_ = {};
  fifo_.clear();
  error_ = DeviceError::kNone;
  if (writer_) {
    writer_->Stop();
  } else {
    GoIdle();
  }
}

// Waits while the FIFO is full and a frame makes room.
bool ShadingDevice::Push(sc_time* delay) {
  const PacketWords packet = staging_;
  while (fifo_.size() >= options_.fifo_packets) {
    if (phase_ == Phase::kIdle) {
      Fail(DeviceError::kFifo);
      return false;
    }
    if (*delay > sc_core::SC_ZERO_TIME) {
      wait(*delay);
      *delay = sc_core::SC_ZERO_TIME;
    } else {
      wait(space_);
    }
  }
  fifo_.push_back(packet);
  work_.notify(sc_core::SC_ZERO_TIME);
  return true;
}

////////////
// Frames //
////////////

void ShadingDevice::Run() {
  for (;;) {
    wait(work_);
    Collect();
    if (phase_ == Phase::kOpen && ended_ && remaining_ == 0) ShadeFrame();
  }
}

// Takes the packets of the open frame out of the FIFO, through the front end.
void ShadingDevice::Collect() {
  while (phase_ == Phase::kOpen && !fifo_.empty() && (!ended_ || remaining_ > 0)) {
    TrianglePacket packet;
    const int materials = static_cast<int>(setup_.state.materials.size());
    if (!discard_) {
      const DeviceError error = DecodePacket(fifo_.front(), materials, &packet);
      if (error == DeviceError::kNone) {
        front_end_->Add(packet, packets_, &frame_work_);
      } else {
        Fail(error);
      }
    }
    ++packets_;
    fifo_.pop_front();
    if (ended_) --remaining_;
    space_.notify(sc_core::SC_ZERO_TIME);
  }
}

void ShadingDevice::ShadeFrame() {
  phase_ = Phase::kShading;
  keeper_.reset();
  SpanWriter writer(setup_.target, std::max(frame_start_, sc_core::sc_time_stamp()),
                    options_.clock_period, initiator_socket.operator->(), &keeper_);
  writer_ = &writer;
  const CoreResult result = Shade(frame_work_, options_.sink, &writer);
  const bool complete = !result.failed && !writer.stopped() && !writer.bus_failed();
  writer.Finish();
  writer_ = nullptr;

  if (complete) {
    SetCounters(result, writer.written());
  } else if (!writer.stopped()) {
    Fail(writer.bus_failed() ? DeviceError::kBus : DeviceError::kCore);
  }
  GoIdle();
}

void ShadingDevice::SetCounters(const CoreResult& result, uint64_t written) {
  const auto set = [this](uint32_t offset, int64_t value) {
    registers_.Set64(offset, static_cast<uint64_t>(value));
  };
  set(OffsetOf("PIXELS"), result.counters.pixels);
  set(OffsetOf("STALL"), result.counters.stall);
  set(OffsetOf("SETUP"), result.counters.setup);
  set(OffsetOf("CYCLES"), result.cycles);
  set(OffsetOf("TRIANGLES"), static_cast<int64_t>(frame_work_.triangles.size()));
  set(OffsetOf("SPANS"), static_cast<int64_t>(frame_work_.spans.size()));
  set(OffsetOf("WRITTEN"), static_cast<int64_t>(written));
  set(OffsetOf("SKIPPED_BACK_FACING"), frame_work_.skipped.back_facing);
  set(OffsetOf("SKIPPED_DEGENERATE"), frame_work_.skipped.degenerate);
  set(OffsetOf("SKIPPED_OFF_SCREEN"), frame_work_.skipped.off_screen);
  set(OffsetOf("SKIPPED_EMPTY"), frame_work_.skipped.empty);
  set(OffsetOf("NORMALISED"), result.counters.normalised);
  set(OffsetOf("NORMALISED_SKIPPED"), result.counters.skipped);
  set(OffsetOf("SAMPLES_TAKEN"), result.counters.samples_taken);
  set(OffsetOf("SAMPLES_EXCLUDED"), result.counters.samples_excluded);
  set(OffsetOf("SAMPLES_SAVED"), result.counters.samples_saved);
  set(OffsetOf("SKIPPED_AMBIENT"), result.counters.ambient);
  set(OffsetOf("SPANS_CONSTANT"), result.counters.constant);
  set(OffsetOf("SPANS_DARK"), result.counters.dark);
  set(OffsetOf("SPANS_UNNORMALISED"), result.counters.unnormalised);
  set(OffsetOf("CHANNELS_BLACK"), result.counters.black);
}

// Also wakes a writer that nobody makes room for any more.
void ShadingDevice::GoIdle() {
  phase_ = Phase::kIdle;
  ended_ = false;
  space_.notify(sc_core::SC_ZERO_TIME);
}

// The first error stays.
void ShadingDevice::Fail(DeviceError error) {
  if (error_ == DeviceError::kNone) error_ = error;
}

}  // namespace shading
