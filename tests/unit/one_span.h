// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/frame_work.h"

namespace shading {

// A triangle of one span at (0, 0) with coefficients of zero.
inline FrameWork OneSpan(Method method, int length) {
  FrameWork work;
  work.method = method;
  work.triangles.emplace_back();
  work.packet.push_back(0);
  work.spans.push_back({0, 0, length, {}, true});
  work.pixels = length;
  return work;
}

}  // namespace shading
