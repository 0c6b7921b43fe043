// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/light/dot_product.h"
#include "model/light/quad_cosine.h"
#include "model/normal/adaptive_normalizer.h"
#include "model/normal/duff_normalizer.h"
#include "model/normal/length_recurrence.h"
#include "model/normal/linear_recurrence.h"
#include "model/normal/phong_direct.h"
#include "model/normal/slerp_direct.h"
#include "model/normal/slerp_direct_setup.h"
#include "model/normal/slerp_paper.h"
#include "model/normal/slerp_recurrence.h"
#include "model/normal/taylor_normalizer.h"
#include "model/shading_types.h"

namespace shading {

// Bit-exact model of rtl/normal/normal_shader.sv: cosines along one span, one class per method.
// At(lane) is the pixel of that lane, Step() moves all lanes by one stride.

// S1.38 -> S1.24: rounds halves up, saturates.
constexpr PixelNormalComponent RoundPixelNormal(Quantity value) {
  constexpr int kExtra = Quantity::kFraction - PixelNormalComponent::kFraction;
  constexpr int64_t kMax = (int64_t{1} << (PixelNormalComponent::kWidth - 1)) - 1;
  const int64_t rounded = (value.raw() + (int64_t{1} << (kExtra - 1))) >> kExtra;
  return PixelNormalComponent::FromRaw(rounded > kMax ? kMax : rounded);
}

// S1.38 -> S1.30: rounds halves up, saturates.
constexpr Cosine RoundQuantity(Quantity value) {
  return RoundSaturateCosine(value.raw(), Quantity::kFraction - Cosine::kFraction);
}

inline LightCosines CosinesOf(const PixelNormal& normal, const LightState& light) {
  return {DotProduct::Of(normal, light.light), DotProduct::Of(normal, light.half_or_view)};
}

// quad-cosine: two surfaces of second order.
template <int kLanes>
class QuadCosineShader {
 public:
  static constexpr int kLatency = 0;

  explicit QuadCosineShader(const std::array<CurveSeed, kCosines>& seed) {
    for (int j = 0; j < kLanes; ++j) {
      n_dot_l_[static_cast<size_t>(j)] = QuadCosine(seed[0], j, kLanes);
      n_dot_h_or_v_[static_cast<size_t>(j)] = QuadCosine(seed[1], j, kLanes);
    }
  }
  LightCosines At(size_t lane, const LightState& /*light*/) const {
    return {n_dot_l_[lane].value(), n_dot_h_or_v_[lane].value()};
  }
  void Step() {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j].Step();
      n_dot_h_or_v_[j].Step();
    }
  }

 private:
  std::array<QuadCosine, kLanes> n_dot_l_, n_dot_h_or_v_;
};

// phong, phong-taylor: a linear normal and its normalisation.
template <typename Normalizer, int kLanes>
class LinearShader {
 public:
  static constexpr int kLatency =
      Normalizer::kContract.latency_cycles + DotProduct::kContract.latency_cycles;

  explicit LinearShader(const NormalSeed& seed) {
    for (size_t q = 0; q < 3; ++q) {
      for (size_t j = 0; j < kLanes; ++j) line_[q][j] = LinearRecurrence(seed.quantity[q][j]);
    }
  }
  LightCosines At(size_t lane, const LightState& light) const {
    return CosinesOf(
        Normalizer::Of({line_[0][lane].value(), line_[1][lane].value(), line_[2][lane].value()}),
        light);
  }
  void Step() {
    for (auto& quantity : line_) {
      for (LinearRecurrence& line : quantity) line.Step();
    }
  }

 private:
  std::array<std::array<LinearRecurrence, kLanes>, 3> line_;
};

// phong-duff: linear cosines over the root of a quadratic.
template <int kLanes>
class DuffShader {
 public:
  static constexpr int kLatency = DuffNormalizer::kContract.latency_cycles;

  explicit DuffShader(const NormalSeed& seed) {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j] = LinearRecurrence(seed.quantity[0][j]);
      n_dot_h_or_v_[j] = LinearRecurrence(seed.quantity[1][j]);
      length_[j] = LengthRecurrence(seed.length_square[j]);
    }
  }
  LightCosines At(size_t lane, const LightState& /*light*/) const {
    return DuffNormalizer::Of(n_dot_l_[lane].value(), n_dot_h_or_v_[lane].value(),
                              length_[lane].value());
  }
  void Step() {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j].Step();
      n_dot_h_or_v_[j].Step();
      length_[j].Step();
    }
  }

 private:
  std::array<LinearRecurrence, kLanes> n_dot_l_, n_dot_h_or_v_;
  std::array<LengthRecurrence, kLanes> length_;
};

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

// Cycles from the walker to the cosines.
constexpr int CosineLatency(Method method) {
  switch (method) {
    case Method::kPhong: return LinearShader<PhongDirect, 1>::kLatency;
    case Method::kPhongTaylor: return LinearShader<TaylorNormalizer, 1>::kLatency;
    case Method::kPhongDuff: return DuffShader<1>::kLatency;
    case Method::kSlerp: return SlerpShader<1>::kLatency;
    case Method::kSlerpPaper: return SlerpPaperShader<1>::kLatency;
    case Method::kSlerpDirect: return SlerpDirectShader<1>::kLatency;
    case Method::kAdaptive:
    case Method::kAdaptivePaper:
    case Method::kAdaptiveChord: return AdaptiveShader<1>::kLatency;
    default: return 0;
  }
}

constexpr AdaptiveKind AdaptiveKindOf(Method method) {
  return method == Method::kAdaptivePaper   ? AdaptiveKind::kExtended
         : method == Method::kAdaptiveChord ? AdaptiveKind::kChord
                                            : AdaptiveKind::kSphere;
}

constexpr SetupKind SetupKindOf(Method method) {
  SetupKind kind;
  kind.spherical = IsSpherical(method);
  kind.cosines = method == Method::kPhongDuff || method == Method::kSlerpIntensity;
  kind.length = method == Method::kPhongDuff;
  return kind;
}

}  // namespace shading
