// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/frame_work.h"
#include "sim/io/image_io.h"
#include "tb/rtl_shading_unit.h"

namespace shading::sim {

// Colour, depth and owner of each pixel. Smaller depth is nearer; of equal ones the first wins.
class FrameBuffer {
 public:
  static constexpr int32_t kNobody = -1;

  FrameBuffer(int width, int height);

  void Put(const Pixel& pixel, int32_t triangle) {
    const size_t at = static_cast<size_t>(pixel.y) * static_cast<size_t>(width_) + pixel.x;
    if (triangle_[at] != kNobody && pixel.z >= depth_[at]) return;
    depth_[at] = pixel.z;
    triangle_[at] = triangle;
    code_[at] = {pixel.r, pixel.g, pixel.b};
  }

  int width() const { return width_; }
  int height() const { return height_; }
  // Index in the triangle list of the triangle that is seen, or kNobody.
  int32_t triangle(size_t at) const { return triangle_[at]; }
  const std::array<uint8_t, 3>& code(size_t at) const { return code_[at]; }
  void SetCode(size_t at, const std::array<uint8_t, 3>& code) { code_[at] = code; }
  size_t size() const { return code_.size(); }

  Image ToImage() const;

 private:
  int width_, height_;
  std::vector<std::array<uint8_t, 3>> code_;
  std::vector<uint32_t> depth_;
  std::vector<int32_t> triangle_;
};

// Puts the pixels of a simulation into a frame buffer.
class PictureConsumer : public tb::PixelConsumer {
 public:
  PictureConsumer(const FrameWork& work, FrameBuffer* frame_buffer)
      : work_(work), frame_buffer_(frame_buffer) {}

  bool Consume(const TimedPixel* pixels, size_t count) override;

 private:
  const FrameWork& work_;
  FrameBuffer* frame_buffer_;
  size_t triangle_ = 0;
  size_t span_ = 0;
};

}  // namespace shading::sim
