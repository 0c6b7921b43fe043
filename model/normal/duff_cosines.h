// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "model/normal/duff_normalizer.h"
#include "model/normal/length_recurrence.h"

namespace shading {

// Bit-exact model of rtl/normal/duff_cosines.sv for all lanes: N.L and N.H of the linear normal
// over the root of |N|^2. Line steps a cosine along a span and has a value: LinearRecurrence S1.38,
// or QuadCosine S1.30. At(lane) is the pixel of that lane, Step() moves all lanes by one stride.
template <typename Line, int kLanes>
class DuffCosines {
 public:
  static constexpr int kLatency = DuffNormalizer::kContract.latency_cycles;

  LightCosines At(size_t lane, const LightState& /*light*/) const {
    return DuffNormalizer::Of(ToQuantity(n_dot_l_[lane].value()),
                              ToQuantity(n_dot_h_or_v_[lane].value()), length_[lane].value());
  }
  void Step() {
    for (size_t j = 0; j < kLanes; ++j) {
      n_dot_l_[j].Step();
      n_dot_h_or_v_[j].Step();
      length_[j].Step();
    }
  }

 protected:
  std::array<Line, kLanes> n_dot_l_, n_dot_h_or_v_;
  std::array<LengthRecurrence, kLanes> length_;

 private:
  static Quantity ToQuantity(Quantity quantity) { return quantity; }
  static Quantity ToQuantity(Cosine cosine) {
    constexpr int kAlign = Quantity::kFraction - Cosine::kFraction;
    return Quantity::FromRaw(cosine.raw() * (int64_t{1} << kAlign));
  }
};

}  // namespace shading
