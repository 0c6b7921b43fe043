// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/span_writer.h"

#include <algorithm>
#include <cstring>

namespace shading {
namespace {

using sc_core::sc_time;

sc_time Remaining(const sc_time& time) {
  const sc_time now = sc_core::sc_time_stamp();
  return time > now ? time - now : sc_core::SC_ZERO_TIME;
}

}  // namespace

SpanWriter::SpanWriter(const FrameBuffer& target, const sc_time& start, const sc_time& period,
                       Bus* bus, tlm_utils::tlm_quantumkeeper* keeper)
    : target_(target),
      start_(start),
      period_(period),
      completed_(start),
      bus_(*bus),
      keeper_(*keeper),
      color_(kWordBytes * kMaxScreen),
      enable_(kWordBytes * kMaxScreen),
      depth_(kMaxScreen) {}

bool SpanWriter::Accept(const Pixel* pixels, int length, int64_t last_cycle) {
  const sc_time left = TimeOf(last_cycle + 1);
  sc_time delay = Remaining(left);
  WriteSpan(pixels, static_cast<size_t>(length), &delay);
  completed_ = std::max(completed_, sc_core::sc_time_stamp() + delay);
  SetLocalTime(left);
  if (keeper_.need_sync()) keeper_.sync();
  return !stopped_ && !bus_failed_;
}

void SpanWriter::Finish() {
  SetLocalTime(completed_);
  keeper_.sync();
}

// The beginning of a cycle.
sc_time SpanWriter::TimeOf(int64_t cycle) const {
  return start_ + sc_time::from_value(period_.value() * static_cast<uint64_t>(cycle));
}

void SpanWriter::SetLocalTime(const sc_time& time) { keeper_.set(Remaining(time)); }

void SpanWriter::WriteSpan(const Pixel* pixels, size_t length, sc_time* delay) {
  const auto x = static_cast<uint64_t>(pixels->x), y = static_cast<uint64_t>(pixels->y);
  const uint64_t color = target_.color_base + y * target_.color_stride + x * kWordBytes;
  const uint64_t depth = target_.depth_base + y * target_.depth_stride + x * kWordBytes;
  const size_t bytes = length * kWordBytes;
  auto* row = reinterpret_cast<uint8_t*>(depth_.data());

  size_t visible = length;
  if (target_.depth_test) {
    Transport(tlm::TLM_READ_COMMAND, depth, row, bytes, false, delay);
    if (bus_failed_) return;
    visible = DepthTest(pixels, length);
    if (visible == 0) return;
  }
  for (size_t i = 0; i < length; ++i) {
    const Pixel& pixel = pixels[i];
    const uint8_t rgba[] = {pixel.r, pixel.g, pixel.b, 255};
    std::memcpy(&color_[i * kWordBytes], rgba, sizeof rgba);
  }
  const bool masked = visible < length;
  Transport(tlm::TLM_WRITE_COMMAND, color, color_.data(), bytes, masked, delay);
  if (target_.depth_test) Transport(tlm::TLM_WRITE_COMMAND, depth, row, bytes, masked, delay);
  if (!bus_failed_) written_ += visible;
}

// Replaces the row by the span's depths, enables the pixels that pass, and counts these.
size_t SpanWriter::DepthTest(const Pixel* pixels, size_t length) {
  size_t visible = 0;
  for (size_t i = 0; i < length; ++i) {
    const bool nearer = pixels[i].z < depth_[i];
    std::memset(&enable_[i * kWordBytes], nearer ? TLM_BYTE_ENABLED : TLM_BYTE_DISABLED,
                kWordBytes);
    depth_[i] = pixels[i].z;
    visible += nearer;
  }
  return visible;
}

void SpanWriter::Transport(tlm::tlm_command command, uint64_t address, uint8_t* data, size_t length,
                           bool masked, sc_time* delay) {
  const auto bytes = static_cast<unsigned>(length);
  payload_.set_command(command);
  payload_.set_address(address);
  payload_.set_data_ptr(data);
  payload_.set_data_length(bytes);
  payload_.set_streaming_width(bytes);
  payload_.set_byte_enable_ptr(masked ? enable_.data() : nullptr);
  payload_.set_byte_enable_length(masked ? bytes : 0);
  payload_.set_dmi_allowed(false);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  bus_.b_transport(payload_, *delay);
  bus_failed_ |= payload_.is_response_error();
}

}  // namespace shading
