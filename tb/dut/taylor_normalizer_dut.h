// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vtaylor_normalizer.h"
#include "Vtaylor_normalizer_taylor_normalizer.h"
#include "tb/dut/normalizer_dut.h"

namespace shading::tb {

// Pins of taylor_normalizer. The only file that includes Vtaylor_normalizer.h.
class TaylorNormalizerDut : public NormalizerDut<Vtaylor_normalizer> {
 public:
  static constexpr int kLatency = Vtaylor_normalizer_taylor_normalizer::Latency;
};

}  // namespace shading::tb
