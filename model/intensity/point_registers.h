// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/word.h"

namespace shading {

// What the units hold that evaluate every pixel from the coefficients: the surface and the offset
// of the pixel, which moves by `lanes` pixels from lane to lane.
template <typename Word>
class PointRegisters {
 public:
  PointRegisters(const SurfacePoint& point, int lane, int lanes)
      : a_(ToWord<Word>(point.surface.a)),
        b_(ToWord<Word>(point.surface.b)),
        c_(ToWord<Word>(point.surface.c)),
        d_(ToWord<Word>(point.surface.d)),
        e_(ToWord<Word>(point.surface.e)),
        f_(ToWord<Word>(point.surface.f)),
        x_(point.x + lane),
        y_(point.y),
        stride_(lanes) {}

  void Step() { x_ += stride_; }

 protected:
  Word x() const { return Word(static_cast<uint64_t>(x_)); }
  Word y() const { return Word(static_cast<uint64_t>(y_)); }

  Word a_, b_, c_, d_, e_, f_;

 private:
  int64_t x_, y_;
  int64_t stride_;
};

}  // namespace shading
