// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/footprint/footprint_types.h"
#include "model/unit_contract.h"

namespace shading {

struct FootprintSample {
  std::array<Quantity, 3> normal;
  bool live = true;  // not excluded
  int weight = 1;    // 1 or 2
};

// Bit-exact model of rtl/footprint/aniso_footprint.sv: the samples of the pixels of one span or
// lane, paper 001 (2), (3). A footprint is an ellipse on the surface and a disc on the screen; the
// normal and the enlarged triangle's barycentrics are affine there, so that a sample is a sum.
//
//   N(s) = N(centre) +- offset_k,   inside(s) = a', b', c' of the sample >= 0
//
// A sample outside the enlarged triangle is excluded; a pixel whose samples are all outside takes
// its centre in place of the last. Sums of components saturate, barycentrics wrap.
class AnisoFootprint {
 public:
  static constexpr UnitContract kContract = {
      "aniso_footprint",
      "footprint",
      3,
      1,
      "normal and offsets S1.38, barycentrics S3.28",
      "normal S1.38, saturates; excluded or not",
      0,
      "exact; barycentrics of pixel x may be (x + 1) 2^-29 off"};

  // Cycles from the turn of a sample to its normal.
  static constexpr int kSampleLatency = 2;

  AnisoFootprint(const Footprint& footprint, const Margins& first, int lane, int lanes);

  // Sample i of the pixel, 0 .. SampleCount - 1 in order, whose centre has this normal.
  FootprintSample Next(int i, const std::array<Quantity, 3>& centre);
  // To the next pixel of the lane.
  void Step();
  int64_t taken() const { return taken_; }  // samples that were not excluded, so far

 private:
  bool IsInside(const Margins& offset, bool negative) const;

  Footprint footprint_;
  Margins margin_, step_;
  bool any_live_ = false;
  int64_t taken_ = 0;
};

}  // namespace shading
