// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/dot_product.h"
#include "model/normal/adaptive_normalizer.h"
#include "model/normal/pixel_normal.h"

namespace shading {

// Cosines of the pixels of one span, a part of rtl/normal/normal_shader.sv: At(lane) is the pixel
// of that lane, Step() moves all lanes by one stride.

// adaptive, adaptive-paper, adaptive-chord: straight lines between normals.
template <int kLanes>
class AdaptiveShader {
 public:
  static constexpr int kLatency = DotProduct::kContract.latency_cycles;

  AdaptiveShader(const AdaptiveSegment* begin, const AdaptiveSegment* end)
      : segment_(begin), end_(end) {
    Step();
  }
  LightCosines At(size_t lane, const LightState& light) const {
    return CosinesOf(normal_[lane], light);
  }
  void Step() {
    for (PixelNormal& normal : normal_) {
      if (left_ == 0 && !Load()) return;
      --left_;
      for (size_t c = 0; c < 3; ++c) {
        normal[c] = RoundPixelNormal(value_[c]);
        value_[c] = Quantity::Wrap(value_[c].raw() + difference_[c].raw());
      }
    }
  }

 private:
  bool Load() {
    if (segment_ == end_) return false;
    left_ = segment_->count;
    value_ = segment_->first;
    difference_ = segment_->difference;
    ++segment_;
    return true;
  }

  const AdaptiveSegment* segment_;
  const AdaptiveSegment* end_;
  int left_ = 0;  // pixels of the segment
  std::array<Quantity, 3> value_, difference_;
  std::array<PixelNormal, kLanes> normal_;
};

}  // namespace shading
