// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "Vslerp_paper.h"
#include "Vslerp_paper_f16.h"
#include "Vslerp_paper_lanes4.h"
#include "Vslerp_paper_slerp_paper.h"
#include "tb/dut/recurrence_dut.h"

namespace shading::tb {

// Pins of slerp_paper, for the builds with other parameters too. The only file that includes
// Vslerp_paper*.h.
template <typename Top, int kLaneCount, int kBits>
class SlerpPaperBuildDut : public RecurrenceDut<Top> {
 public:
  static constexpr int kLatency = Vslerp_paper_slerp_paper::Latency;
  static constexpr int kLanes = kLaneCount, kFractionBits = kBits;  // as in CMakeLists.txt

  Quantity value(int lane = 0) const {
    if constexpr (kLanes == 1) {
      return this->ValueOf(this->top().value_o);
    } else {
      BitReader bits(this->top().value_o);
      for (int skipped = 0; skipped < lane; ++skipped) bits.Take(Quantity::kWidth);
      return bits.template TakeSigned<Quantity>();
    }
  }

  // One clock cycle; value() is the output after its edge.
  void Cycle(bool load, bool step, const std::array<QuantitySeed, kMaxLanes>& seed,
             const std::array<Kappa, 2>& step_kappa) {
    BitPacker<kLanes == 1 ? 3 : 10> seeds;
    for (size_t lane = 0; lane < kLanes; ++lane) PutQuantitySeed(seed[lane], seeds);
    seeds.Store(this->top().seed_i);
    BitPacker<3> kappas;
    for (const Kappa& kappa : step_kappa) PutKappa(kappa, kappas);
    kappas.Store(this->top().step_kappa_i);
    RecurrenceDut<Top>::Cycle(load, step);
  }
};

using SlerpPaperDut = SlerpPaperBuildDut<Vslerp_paper, 1, 38>;
using SlerpPaperF16Dut = SlerpPaperBuildDut<Vslerp_paper_f16, 1, 16>;
using SlerpPaperLanes4Dut = SlerpPaperBuildDut<Vslerp_paper_lanes4, 4, 38>;

}  // namespace shading::tb
