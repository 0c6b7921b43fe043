// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/light/light_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/footprint/footprint_mean.sv: the light of a pixel as the mean of its
// samples' light, paper 001.
//
//   mean = sum w_s value_s / sum w_s      over the samples that are not excluded, w = 1 or 2
//
// The sums are exact, the quotient is rounded to nearest, halves up; 0 without a sample.
class FootprintMean {
 public:
  static constexpr UnitContract kContract = {"footprint_mean",
                                             "footprint",
                                             3,
                                             1,
                                             "diffuse U1.17, highlight U1.16, weights 1 and 2",
                                             "diffuse U1.17, highlight U1.16, round to nearest",
                                             0.5,
                                             "sums of weights up to 8, each output in its own ulp"};

  // What a sample adds to the mean.
  struct Light {
    Diffuse diffuse;
    Highlight highlight;
    bool unlit = true;    // N.L <= 0; of a mean: of every sample
    bool skipped = true;  // the power was not computed
  };

  void Add(const Light& light, int weight) {
    diffuse_ += light.diffuse.raw() * weight;
    highlight_ += light.highlight.raw() * weight;
    count_ += weight;
    unlit_ &= light.unlit;
    skipped_ &= light.skipped;
  }

  Light Mean() const {
    return {Diffuse::FromRaw(Divided(diffuse_)), Highlight::FromRaw(Divided(highlight_)), unlit_,
            skipped_};
  }
  int count() const { return count_; }

 private:
  static constexpr int kFraction = 26;
  // ceil(2^26 / 2k)
  static constexpr std::array<int64_t, 9> kReciprocal = {
      0, 33554432, 16777216, 11184811, 8388608, 6710887, 5592406, 4793491, 4194304};

  int64_t Divided(int64_t sum) const {
    return ((2 * sum + count_) * kReciprocal[static_cast<size_t>(count_)]) >> kFraction;
  }

  int64_t diffuse_ = 0, highlight_ = 0;
  int count_ = 0;
  bool unlit_ = true, skipped_ = true;
};

}  // namespace shading
