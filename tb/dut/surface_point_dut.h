// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <memory>

#include "model/shading_types.h"
#include "tb/bit_packer.h"

namespace shading::tb {

inline constexpr int kOffsetWidth = 13;

// surface_point_t of shading_pkg.sv at a Verilated port.
template <typename Port>
void DriveSurfacePoint(const SurfacePoint& point, Port& port) {
  BitPacker<8> bits;
  bits.Put(point.y, kOffsetWidth);
  bits.Put(point.x, kOffsetWidth);
  const Surface& s = point.surface;
  for (const IntensityAcc value : {s.f, s.e, s.d, s.c, s.b, s.a}) bits.Put(value);
  bits.Store(port);
}

// Pins of the units that evaluate the surface at a point: point and load command in, a code out.
// They have no handshake, so nothing ever waits for them. Top is a Verilated class.
template <typename Top>
class SurfacePointDut {
 public:
  SurfacePointDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {}

  uint8_t code() const { return top_->code_o; }

  // One clock cycle; code() is the output after its edge.
  void Cycle(bool load, bool step, const SurfacePoint& point) {
    top_->load_i = load;
    top_->step_i = step;
    DriveSurfacePoint(point, top_->point_i);
    top_->clk_i = 0;
    top_->eval();
    top_->clk_i = 1;
    top_->eval();
  }

 private:
  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
};

}  // namespace shading::tb
