// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <verilated.h>

#include <array>
#include <memory>

#include "Vpixel_queue.h"
#include "Vpixel_queue4.h"
#include "Vpixel_queue_pixel_queue.h"
#include "Vpixel_queue_shaded.h"
#include "Vpixel_queue_shaded4.h"
#include "tb/dut/pins.h"

namespace shading::tb {

// A group of pixels on its way through pixel_queue.
template <int kLanes>
struct PixelGroup {
  std::array<Pixel, kLanes> pixel = {};  // positions as they enter, with their codes
  uint32_t mask = 0;                     // bit j: lane j holds a pixel
  int material = 0;
  bool dark = false;
  bool shaded = false;  // enters with its codes, and is not lit
  uint32_t unlit = 0, no_highlight = 0;
};

// Pins of pixel_queue, cycle by cycle; Top is the build with these parameters. The only file that
// includes Vpixel_queue.h, Vpixel_queue4.h, Vpixel_queue_shaded.h and Vpixel_queue_shaded4.h.
template <typename Top, int kLanes, bool kShaded>
class PixelQueueBuildDut {
 public:
  static constexpr int kLatency = Vpixel_queue_pixel_queue::Latency;
  static constexpr int kLaneCount = kLanes;
  static constexpr bool kHasShaded = kShaded;
  using Group = PixelGroup<kLanes>;

  PixelQueueBuildDut()
      : context_(std::make_unique<VerilatedContext>()),
        top_(std::make_unique<Top>(context_.get())) {
    Reset();
  }

  void Reset() {
    Enter(false, {});
    Cosines(false);
    Light(false, {});
    Ready(false);
    top_->rst_ni = 0;
    Tick();
    top_->rst_ni = 1;
    Settle();
  }

  // What the four sides do in this cycle. The codes of a group count when it is shaded.
  void Enter(bool valid, const Group& group) {
    top_->enter_valid_i = valid;
    BitPacker<kLanes == 1 ? 2 : 7> bits;
    for (const Pixel& pixel : group.pixel) {
      bits.Put(pixel.last, 1);
      bits.Put(pixel.z, Depth::kWidth);
      bits.Put(pixel.y, kCoordWidth);
      bits.Put(pixel.x, kCoordWidth);
    }
    StoreBits(bits, top_->position_i);
    top_->mask_i = static_cast<uint8_t>(group.mask);
    top_->material_i = static_cast<uint8_t>(group.material);
    top_->dark_i = group.dark;
    top_->shaded_i = group.shaded;
    StoreBits(CodesOf(group), top_->shaded_code_i);
  }
  void Cosines(bool valid) { top_->cosines_valid_i = valid; }
  void Light(bool valid, const Group& group) {
    top_->code_valid_i = valid;
    StoreBits(CodesOf(group), top_->code_i);
    top_->unlit_i = static_cast<uint8_t>(group.unlit);
    top_->no_highlight_i = static_cast<uint8_t>(group.no_highlight);
  }
  void Ready(bool ready) { top_->pixel_ready_i = ready; }

  void Settle() {
    top_->clk_i = 0;
    top_->eval();
  }
  void Tick() {
    Settle();
    top_->clk_i = 1;
    top_->eval();
  }

  // What it answers, after Settle().
  bool enter_ready() const { return top_->enter_ready_o; }
  int material() const { return top_->material_o; }
  bool dark() const { return top_->dark_o; }
  bool pixel_valid() const { return top_->pixel_valid_o; }
  Pixel pixel(size_t lane) const { return ReadPixel(top_->pixel_o, static_cast<int>(lane)); }
  uint32_t mask() const { return top_->mask_o; }
  uint32_t unlit() const { return top_->unlit_o; }
  uint32_t no_highlight() const { return top_->no_highlight_o; }
  bool busy() const { return top_->busy_o; }

 private:
  static BitPacker<kLanes == 1 ? 1 : 3> CodesOf(const Group& group) {
    BitPacker<kLanes == 1 ? 1 : 3> bits;
    for (const Pixel& pixel : group.pixel) {
      for (const uint8_t code : {pixel.r, pixel.g, pixel.b}) bits.Put(code, Code::kWidth);
    }
    return bits;
  }

  std::unique_ptr<VerilatedContext> context_;  // outlives the top that lives in it
  std::unique_ptr<Top> top_;
};

using PixelQueueDut = PixelQueueBuildDut<Vpixel_queue, 1, false>;
using PixelQueue4Dut = PixelQueueBuildDut<Vpixel_queue4, 4, false>;
using PixelQueueShadedDut = PixelQueueBuildDut<Vpixel_queue_shaded, 1, true>;
using PixelQueueShaded4Dut = PixelQueueBuildDut<Vpixel_queue_shaded4, 4, true>;

}  // namespace shading::tb
