// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vphong_direct.h"
#include "Vphong_direct_phong_direct.h"
#include "tb/dut/normalizer_dut.h"

namespace shading::tb {

// Pins of phong_direct. The only file that includes Vphong_direct.h.
class PhongDirectDut : public NormalizerDut<Vphong_direct> {
 public:
  static constexpr int kLatency = Vphong_direct_phong_direct::Latency;
};

}  // namespace shading::tb
