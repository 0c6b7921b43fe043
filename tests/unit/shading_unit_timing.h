// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/footprint/footprint_mean.h"
#include "model/light/pixel_light.h"
#include "model/normal/normal_setup.h"
#include "model/normal/normal_shader.h"
#include "model/raster/pixel_queue.h"
#include "model/raster/span_setup.h"

namespace shading {

// slerp_direct_setup stands behind normal_setup.
inline int ArcLatency(Method method) {
  return method == Method::kSlerpDirect ? SlerpDirectSetup::kContract.latency_cycles : 0;
}

// Cycles from a span to its first pixel, the unit idle.
inline int Latency(Method method) {
  const int light = PixelLight::kContract.latency_cycles +
                    (IsFootprint(method) ? FootprintMean::kContract.latency_cycles : 0) +
                    PixelQueue::kContract.latency_cycles;
  if (IsAdaptive(method)) {
    return AdaptiveNormalizer::kContract.latency_cycles - 1 + CosineLatency(method) + light +
           (method == Method::kAdaptivePaper ? AdaptiveNormalizer::kExtend
            : method == Method::kAdaptiveChord
                ? AdaptiveNormalizer::kChordEnds + AdaptiveNormalizer::kChordTest
                : 0);
  }
  // Equal normals make it flat; seed_queue and pixel_queue come on top.
  if (method == Method::kAuto) return SpanSetup::kContract.latency_cycles + 2;
  if (!InterpolatesNormals(method)) {
    return SpanSetup::kContract.latency_cycles +
           (LightsPixels(method) ? CosineLatency(method) + light : 0);
  }
  return NormalSetup::Latency(1) + ArcLatency(method) + CosineLatency(method) + light;
}

// The shortest spans that hide the set-up of the next.
inline int HidingLength(Method method) {
  switch (method) {
    case Method::kAdaptive: return AdaptiveNormalizer::kSetup;
    case Method::kAdaptivePaper: return AdaptiveNormalizer::kSetup + AdaptiveNormalizer::kExtend;
    case Method::kAdaptiveChord:
      return 1 + AdaptiveNormalizer::kChordEnds + AdaptiveNormalizer::kChordTest;
    default: return InterpolatesNormals(method) ? NormalSetup::kSteps : SpanSetup::Steps(method, 0);
  }
}

}  // namespace shading
