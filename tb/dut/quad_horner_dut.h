// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_horner.h"
#include "Vquad_horner_3of4.h"
#include "Vquad_horner_quad_horner.h"
#include "tb/dut/surface_point_dut.h"

namespace shading::tb {

// Pins of quad_horner; Top is the build for one lane. The only file that includes Vquad_horner*.h.
template <typename Top>
class QuadHornerBuildDut : public SurfacePointDut<Top> {
 public:
  static constexpr int kLatency = Vquad_horner_quad_horner::Latency;
};

// The only lane of one, and the last of four: parameters as in tests/unit/intensity/CMakeLists.txt.
using QuadHornerDut = QuadHornerBuildDut<Vquad_horner>;
using QuadHornerLane3Of4Dut = QuadHornerBuildDut<Vquad_horner_3of4>;

}  // namespace shading::tb
