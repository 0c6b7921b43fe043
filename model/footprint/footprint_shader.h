// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/footprint/footprint_light.h"
#include "model/normal/linear_recurrence.h"
#include "model/shading_types.h"

namespace shading {

// Mean light of the pixels of one span, a part of rtl/normal/normal_shader.sv and
// rtl/light/pixel_light.sv: Mean(lane) is the pixel of that lane, Step() moves all lanes by one
// stride.
template <int kLanes>
class FootprintShader {
 public:
  // Cycles from a sample's turn to its cosines.
  static constexpr int kLatency = AnisoFootprint::kSampleLatency +
                                  PhongDirect::kContract.latency_cycles +
                                  DotProduct::kContract.latency_cycles;

  FootprintShader(const NormalSeed& seed, const Footprint& footprint, const Margins& first)
      : pattern_(footprint.pattern), samples_(Samples(footprint, first)) {
    for (size_t q = 0; q < 3; ++q) {
      for (size_t j = 0; j < kLanes; ++j) line_[q][j] = LinearRecurrence(seed.quantity[q][j]);
    }
  }

  FootprintMean::Light Mean(size_t lane, const FootprintLight& light) {
    return light.Mean(pattern_,
                      {line_[0][lane].value(), line_[1][lane].value(), line_[2][lane].value()},
                      &samples_[lane]);
  }
  void Step() {
    for (auto& quantity : line_) {
      for (LinearRecurrence& line : quantity) line.Step();
    }
    for (AnisoFootprint& samples : samples_) samples.Step();
  }
  // Samples that were not excluded, so far.
  int64_t taken() const {
    int64_t sum = 0;
    for (const AnisoFootprint& samples : samples_) sum += samples.taken();
    return sum;
  }

 private:
  using LaneSamples = std::array<AnisoFootprint, kLanes>;

  static LaneSamples Samples(const Footprint& footprint, const Margins& first) {
    if constexpr (kLanes == 1) {
      return {AnisoFootprint(footprint, first, 0, 1)};
    } else {
      return {
          AnisoFootprint(footprint, first, 0, kLanes), AnisoFootprint(footprint, first, 1, kLanes),
          AnisoFootprint(footprint, first, 2, kLanes), AnisoFootprint(footprint, first, 3, kLanes)};
    }
  }

  FootprintPattern pattern_;
  std::array<std::array<LinearRecurrence, kLanes>, 3> line_;
  LaneSamples samples_;
};

}  // namespace shading
