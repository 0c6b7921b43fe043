// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vlinear_recurrence.h"
#include "Vlinear_recurrence_linear_recurrence.h"
#include "tb/dut/recurrence_dut.h"

namespace shading::tb {

// Pins of linear_recurrence. The only file that includes Vlinear_recurrence.h.
class LinearRecurrenceDut : public RecurrenceDut<Vlinear_recurrence> {
 public:
  static constexpr int kLatency = Vlinear_recurrence_linear_recurrence::Latency;

  Quantity value() const { return ValueOf(top().value_o); }

  // One clock cycle; value() is the output after its edge.
  void Cycle(bool load, bool step, const QuantitySeed& seed) {
    BitPacker<3> bits;
    PutQuantitySeed(seed, bits);
    bits.Store(top().seed_i);
    RecurrenceDut::Cycle(load, step);
  }
};

}  // namespace shading::tb
