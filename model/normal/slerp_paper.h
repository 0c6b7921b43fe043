// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>

#include "model/fixed/wide_integer.h"
#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

// Bit-exact model of rtl/normal/slerp_paper.sv: one quantity of one span in the form of paper 000,
// one or four pixels per step. c = 2 cos(phi), c' = 2 cos(2 phi).
//
//   N(t+1) = c N(t) - N(t-1)                                   (7)
//   N(t+2) = (c' + 1) N(t) - c N(t-1)                          (9)
//   N(t+3) = c' (c N(t) - N(t-1)) - N(t-1)                     (10), corrected
//   N(t+4) = c' ((c' + 1) N(t) - c N(t-1)) - N(t)              (11), corrected
//
// State and factors have `fraction_bits` F; each line above is rounded half up once and wraps at
// S1.F. Products of two 40-bit numbers need Int128.
class SlerpPaper {
 public:
  static constexpr UnitContract kContract = {
      "slerp_paper",
      "normal",
      1,
      1,
      "seed S1.38, kappa U1.28 with exponent of 4, 0..10",
      "value S1.38, wraps",
      2098200,
      "1 lane of 38 fraction bits, 2048 pixels, amplitude 1"};

  // One lane uses seed[0] and the kappa of phi; four lanes use `first` of all seeds and the kappas
  // of phi and 2 phi.
  SlerpPaper(const std::array<QuantitySeed, kMaxLanes>& seed,
             const std::array<Kappa, 2>& step_kappa, int lanes = 1, int fraction_bits = 38)
      : lanes_(lanes),
        fraction_(fraction_bits),
        cos_(Factor(step_kappa[0])),
        double_cos_(Factor(step_kappa[1])) {
    assert(lanes == 1 || lanes == kMaxLanes);
    for (size_t lane = 0; lane < seed.size(); ++lane) pixel_[lane] = ToState(seed[lane].first);
    if (lanes == 1) {
      pixel_[1] = ToState(Quantity::Wrap(seed[0].first.raw() + seed[0].difference.raw()));
    }
  }

  Quantity value(int lane = 0) const {
    return Quantity::FromRaw(pixel_[static_cast<size_t>(lane)] * (int64_t{1} << Dropped()));
  }
  void Step() {
    if (lanes_ == 1) {
      StepOne();
    } else {
      StepFour();
    }
  }

 private:
  int Dropped() const { return Quantity::kFraction - fraction_; }
  int64_t Wrap(int64_t raw) const {  // at S1.F
    const int align = 62 - fraction_;
    return static_cast<int64_t>(static_cast<uint64_t>(raw) << align) >> align;
  }
  int64_t ToState(Quantity value) const {
    return Wrap((value.raw() + ((int64_t{1} << Dropped()) >> 1)) >> Dropped());
  }
  // 2 - kappa as U2.F, kappa rounded half up.
  int64_t Factor(const Kappa& kappa) const {
    const int extra = kappa.mantissa.kFraction + 2 * kappa.exponent - (fraction_ + 1);
    const int64_t m = kappa.mantissa.raw();
    const int64_t scaled = extra < 0 ? m << -extra : m >> extra;  // one bit more than F
    return (int64_t{2} << fraction_) - ((scaled + 1) >> 1);
  }
  int64_t RoundSum(Int128 sum) const {
    return static_cast<int64_t>((sum + (Int128{1} << (fraction_ - 1))) >> fraction_);
  }
  static Int128 Multiply(int64_t factor, int64_t value) {
    return static_cast<Int128>(factor) * value;
  }

  void StepOne() {
    const int64_t next = Wrap(RoundSum(Multiply(cos_, pixel_[1])) - pixel_[0]);
    pixel_[0] = pixel_[1];
    pixel_[1] = next;
  }
  void StepFour() {
    const int64_t before = pixel_[2], last = pixel_[3];
    const int64_t double_cos_1 = double_cos_ + (int64_t{1} << fraction_);
    const int64_t next_1 = Wrap(RoundSum(Multiply(cos_, last)) - before);
    const int64_t next_2 = Wrap(RoundSum(Multiply(double_cos_1, last) - Multiply(cos_, before)));
    pixel_[0] = next_1;
    pixel_[1] = next_2;
    pixel_[2] = Wrap(RoundSum(Multiply(double_cos_, next_1)) - before);
    pixel_[3] = Wrap(RoundSum(Multiply(double_cos_, next_2)) - last);
  }

  int lanes_;
  int fraction_;                               // F
  int64_t cos_, double_cos_;                   // c, c': U2.F
  std::array<int64_t, kMaxLanes> pixel_ = {};  // N(t), N(t+1); four lanes: N(t) .. N(t+3)
};

}  // namespace shading
