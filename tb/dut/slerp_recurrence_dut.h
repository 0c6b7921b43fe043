// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vslerp_recurrence.h"
#include "Vslerp_recurrence_slerp_recurrence.h"
#include "tb/dut/recurrence_dut.h"

namespace shading::tb {

// Pins of slerp_recurrence. The only file that includes Vslerp_recurrence.h.
class SlerpRecurrenceDut : public RecurrenceDut<Vslerp_recurrence> {
 public:
  static constexpr int kLatency = Vslerp_recurrence_slerp_recurrence::Latency;

  Quantity value() const { return ValueOf(top().value_o); }

  // One clock cycle; value() is the output after its edge.
  void Cycle(bool load, bool step, const QuantitySeed& seed, const Kappa& kappa) {
    BitPacker<3> bits;
    PutQuantitySeed(seed, bits);
    bits.Store(top().seed_i);
    top().kappa_i =
        static_cast<uint64_t>(kappa.mantissa.raw()) << 4 | static_cast<uint64_t>(kappa.exponent);
    RecurrenceDut::Cycle(load, step);
  }
};

}  // namespace shading::tb
