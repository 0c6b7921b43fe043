// SPDX-License-Identifier: Apache-2.0
#include "sim/frame_buffer.h"

namespace shading::sim {

FrameBuffer::FrameBuffer(int width, int height)
    : width_(width),
      height_(height),
      code_(static_cast<size_t>(width) * static_cast<size_t>(height)),
      depth_(code_.size()),
      triangle_(code_.size(), kNobody) {}

Image FrameBuffer::ToImage() const {
  Image image{width_, height_, code_, std::vector<uint8_t>(code_.size())};
  for (size_t at = 0; at < code_.size(); ++at) image.covered[at] = triangle_[at] != kNobody;
  return image;
}

bool PictureConsumer::Consume(const TimedPixel* pixels, size_t count) {
  for (size_t i = 0; i < count; ++i) {
    const Pixel& pixel = pixels[i].pixel;
    const bool on_screen = pixel.x < frame_buffer_->width() && pixel.y < frame_buffer_->height();
    if (span_ == work_.spans.size() || !on_screen) return false;
    frame_buffer_->Put(pixel, static_cast<int32_t>(work_.packet[triangle_]));
    if (pixel.last && work_.spans[span_++].last) ++triangle_;
  }
  return true;
}

}  // namespace shading::sim
