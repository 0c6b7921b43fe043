// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "model/light/light_types.h"
#include "model/normal/normal_types.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

// Where the normals between the ends of a span come from. Twin of adaptive_kind_e.
enum class AdaptiveKind {
  kSphere,    // bisection of the span itself: slerp
  kExtended,  // the paper's: bisection of the span extended to a power of 2
  kChord      // normalised points of the chord: Phong
};

// Pixels between two normalised normals: N(i) = first + i difference.
struct AdaptiveSegment {
  std::array<Quantity, 3> first;       // at its first pixel
  std::array<Quantity, 3> difference;  // from pixel to pixel
  int count = 0;                       // pixels
  bool last = false;                   // of its span
  int steps = 0;                       // cycles of division since the segment before
};

// Bit-exact model of rtl/normal/adaptive_normalizer.sv: paper 002. A span is halved until the angle
// of every part is within the limit; only the normals at the borders are normalised.
//
//   N(mid) = (Nl + Nr) / z_j,  z_j = 2 cos(eta_j / 2)          (1); eta_j: angle of level j
//   x_j = 1 - cos(eta_j):  1/z_j = 1/sqrt(4 - 2 x_j),  x_(j+1) = 1 - sqrt(1 - x_j/2)
//   J: the first level with x_j <= limit, or kMostLevels
//   inside a part     N_i = N_p + i dN,  dN = (N_g - N_p) 2^j / m      m: steps of the span
//
// Parts without a pixel inside, ends excepted, are not divided further: a line is exact at its
// ends. All parts of a level have the same angle, so one ladder of 1/z serves the span; kChord,
// whose parts differ, compares |N_g - N_p|^2 / 2 of each with the limit.
//
// Rounded half up: x_0 and 1/z U1.32, normals S1.30, dN and its offset S1.38; sums wrap. An angle
// above 120 degrees counts as 120; up to 120 the error beyond the tolerance is 0.036 codes.
class AdaptiveNormalizer {
 public:
  static constexpr UnitContract kContract = {
      "adaptive_normalizer",
      "normal",
      10,
      4,
      "normals S1.30, limit U0.30, 1..4096 pixels",
      "normals S1.24, not normalised inside a segment",
      0.009,
      "codes beyond the tolerance, N.L and (N.H)^n, n <= 256, kSphere up to 90 degrees"};

  static constexpr int kMostLevels = 12;  // a part is a pixel's 4096th of the longest span
  static constexpr int kSetup = 4;        // cycles of set-up, and for each level
  static constexpr int kLevelSetup = 3;
  static constexpr int kExtend = 19;         // and for the extended end
  static constexpr int kChordEnds = 14;      // cycles of division for the two ends of a chord
  static constexpr int kChordTest = 2;       // for the comparison of a part
  static constexpr int kChordSplit = 11;     // more for its middle
  static constexpr int kSegmentLatency = 4;  // from the division to the queue of segments
  static constexpr int kQueue = 8;           // segments between division and pixels

  AdaptiveNormalizer(AdaptiveKind kind, const std::array<SpanNormal, 2>& normal, int length,
                     AngleLimit limit);

  bool Next(AdaptiveSegment* segment);  // false after the last

  int setup_cycles() const { return setup_cycles_; }
  int levels() const { return levels_; }
  int64_t Divisor(int level) const { return divisor_[static_cast<size_t>(level)]; }  // 1/z U1.32
  int normalisations() const { return normalisations_; }  // of the segments so far
  int skipped() const {                                   // after the last segment
    return normalisations_ < length() ? length() - normalisations_ : 0;
  }

  // The limits that keep a full-scale component within `tolerance` codes, rounded down. With
  // delta = 1 - cos(eta / 2), of an angle eta:
  //   diffuse    N.L       delta <= tol                1 - cos(eta) <= 4 tol - 2 tol^2
  //   specular   (N.H)^n   n (1 - cos eta) / 4 <= tol  for n >= 2; 1 < n < 2 errs less than 2
  //              (R.V)^n   n (1 - cos eta) <= tol      R.V = 2 (N.L)(N.V) - L.V has |N|^2
  static AngleLimit DiffuseLimit(Tolerance tolerance);
  static AngleLimit SpecularLimit(Tolerance tolerance, Shininess shininess,
                                  Lighting lighting = Lighting::kBlinn);
  // The smaller one: both cosines of a pixel come from one normal. A material without specular
  // reflectance has only the first.
  static AngleLimit LimitOf(Tolerance tolerance, Shininess shininess, bool specular,
                            Lighting lighting = Lighting::kBlinn);

  // S1.38 -> S1.24: rounds halves up, saturates.
  static PixelNormal Rounded(const std::array<Quantity, 3>& normal);

 private:
  // The right end of a part that is not done, and the level of the part.
  struct Pending {
    SpanNormal normal;
    int level;
  };

  void SetUp(AngleLimit limit);
  SpanNormal ExtendedEnd() const;
  SpanNormal Middle(int level);
  SpanNormal ChordPoint(int64_t place) const;
  bool Small() const;
  bool Divides();
  void Fill(AdaptiveSegment* segment) const;
  void Pass();
  Pending& top() { return pending_[static_cast<size_t>(depth_)]; }
  const Pending& top() const { return pending_[static_cast<size_t>(depth_)]; }
  int length() const { return static_cast<int>(last_pixel_) + 1; }
  int64_t right() const { return place_ + ((width_ << kMostLevels) >> level_); }

  AdaptiveKind kind_;
  std::array<SpanNormal, 2> end_;
  int64_t last_pixel_;
  int64_t limit_;
  int64_t width_;    // steps of what is halved: of the span, or a power of 2
  int64_t inverse_;  // 2^exponent_ / width_, U1.30
  int exponent_;
  int levels_ = kMostLevels;
  int setup_cycles_ = kSetup;
  std::array<int64_t, kMostLevels> divisor_ = {};  // 1/z_j

  // The part at hand: from pixel place_ (12 fraction bits), level_, its left and right normal.
  SpanNormal left_;
  std::array<Pending, kMostLevels + 1> pending_;
  int depth_ = 0;
  int level_ = 0;
  int64_t place_ = 0;
  bool done_ = false;
  int steps_ = 0;
  int normalisations_ = 0;
};

}  // namespace shading
