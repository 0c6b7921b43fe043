// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/dot_product.h"
#include "model/normal/normal_types.h"
#include "model/normal/pixel_normal.h"
#include "model/normal/slerp_direct.h"
#include "model/normal/slerp_direct_setup.h"
#include "model/normal/slerp_paper.h"
#include "model/normal/slerp_recurrence.h"

namespace shading {

// Cosines of the pixels of one span, a part of rtl/normal/normal_shader.sv: At(lane) is the pixel
// of that lane, Step() moves all lanes by one stride.

// slerp: three spherical recurrences.
template <int kLanes>
class SlerpShader {
 public:
  static constexpr int kLatency = DotProduct::kContract.latency_cycles;

  explicit SlerpShader(const NormalSeed& seed) {
    for (size_t q = 0; q < 3; ++q) {
      for (size_t j = 0; j < kLanes; ++j) {
        arc_[q][j] = SlerpRecurrence(seed.quantity[q][j], seed.kappa);
      }
    }
  }
  LightCosines At(size_t lane, const LightState& light) const {
    return CosinesOf(
        {RoundPixelNormal(arc_[0][lane].value()), RoundPixelNormal(arc_[1][lane].value()),
         RoundPixelNormal(arc_[2][lane].value())},
        light);
  }
  void Step() {
    for (auto& quantity : arc_) {
      for (SlerpRecurrence& arc : quantity) arc.Step();
    }
  }

 private:
  std::array<std::array<SlerpRecurrence, kLanes>, 3> arc_;
};

// slerp-paper: the same by paper 000 (7), and (9) to (11) for four lanes.
template <int kLanes>
class SlerpPaperShader {
 public:
  static constexpr int kLatency = DotProduct::kContract.latency_cycles;

  explicit SlerpPaperShader(const NormalSeed& seed, int fraction_bits = Quantity::kFraction)
      : arc_{Arc(seed, 0, fraction_bits), Arc(seed, 1, fraction_bits),
             Arc(seed, 2, fraction_bits)} {}
  LightCosines At(size_t lane, const LightState& light) const {
    const int at = static_cast<int>(lane);
    return CosinesOf({RoundPixelNormal(arc_[0].value(at)), RoundPixelNormal(arc_[1].value(at)),
                      RoundPixelNormal(arc_[2].value(at))},
                     light);
  }
  void Step() {
    for (SlerpPaper& arc : arc_) arc.Step();
  }

 private:
  static SlerpPaper Arc(const NormalSeed& seed, size_t q, int fraction_bits) {
    const auto& kappa =
        kLanes == 1 ? std::array<Kappa, 2>{seed.kappa, seed.kappa} : seed.step_kappa;
    return SlerpPaper(seed.quantity[q], kappa, kLanes, fraction_bits);
  }
  std::array<SlerpPaper, 3> arc_;
};

// slerp-direct: the same by paper 000 (6), from the seeds of one pixel's stride.
template <int kLanes>
class SlerpDirectShader {
 public:
  static constexpr int kLatency =
      SlerpDirect::kContract.latency_cycles + DotProduct::kContract.latency_cycles;

  explicit SlerpDirectShader(const NormalSeed& seed) : SlerpDirectShader(ArcOf(seed)) {}
  LightCosines At(size_t lane, const LightState& light) const {
    return CosinesOf(lane_[lane].normal(), light);
  }
  void Step() {
    for (SlerpDirect& lane : lane_) lane.Step();
  }

 private:
  explicit SlerpDirectShader(const SpanArc& arc) {
    for (int j = 0; j < kLanes; ++j) lane_[static_cast<size_t>(j)] = SlerpDirect(arc, j, kLanes);
  }
  static SpanArc ArcOf(const NormalSeed& seed) {
    std::array<QuantitySeed, 3> step;
    for (size_t q = 0; q < 3; ++q) {
      const auto& lanes = seed.quantity[q];
      step[q] = lanes[0];
      if (kLanes > 1) {
        step[q].difference = Quantity::Wrap(lanes[1].first.raw() - lanes[0].first.raw());
      }
    }
    return SlerpDirectSetup::Of(step, kLanes == 1 ? seed.kappa : seed.step_kappa[0]);
  }
  std::array<SlerpDirect, kLanes> lane_;
};

// slerp-intensity: two spherical recurrences, no vectors.
template <int kLanes>
class SlerpIntensityShader {
 public:
  static constexpr int kLatency = 0;

  explicit SlerpIntensityShader(const NormalSeed& seed) {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j] = SlerpRecurrence(seed.quantity[0][j], seed.kappa);
      n_dot_h_or_v_[j] = SlerpRecurrence(seed.quantity[1][j], seed.kappa);
    }
  }
  LightCosines At(size_t lane, const LightState& /*light*/) const {
    return {RoundQuantity(n_dot_l_[lane].value()), RoundQuantity(n_dot_h_or_v_[lane].value())};
  }
  void Step() {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j].Step();
      n_dot_h_or_v_[j].Step();
    }
  }

 private:
  std::array<SlerpRecurrence, kLanes> n_dot_l_, n_dot_h_or_v_;
};

}  // namespace shading
