// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "model/tlm/frame_registers.h"

namespace shading {

// Software side of the register map: what a device driver does, over any way to reach registers.
//
//   driver.Start(frame, method, target);
//   for (packet : triangles) driver.Push(packet);
//   driver.End();
//   while (driver.Busy()) ...;
class ShadingDriver {
 public:
  class Bus {
   public:
    virtual ~Bus() = default;
    // Consecutive registers; offsets in bytes.
    virtual void Write(uint32_t offset, const uint32_t* words, size_t count) = 0;
    virtual uint32_t Read(uint32_t offset) = 0;
  };

  explicit ShadingDriver(Bus* bus) : bus_(*bus) {}

  void Start(const FrameState& frame, Method method, const FrameBuffer& target);
  void Push(const TrianglePacket& packet);
  void End() { WriteWord(OffsetOf("CONTROL"), kControlEnd); }
  void Reset() { WriteWord(OffsetOf("CONTROL"), kControlReset); }

  uint32_t Status() { return bus_.Read(OffsetOf("STATUS")); }
  bool Busy() { return (Status() & kStatusBusy) != 0; }
  DeviceError Error() { return static_cast<DeviceError>(StatusError(Status())); }
  uint64_t Counter(std::string_view name);

 private:
  void WriteWord(uint32_t offset, uint32_t word) { bus_.Write(offset, &word, 1); }
  void WriteVector(uint32_t offset, const Vector3& vector);
  void WritePlane(uint32_t base_offset, uint64_t base, uint32_t stride_offset, uint32_t stride);

  Bus& bus_;
};

}  // namespace shading
