// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Vquad_polynomial.h"
#include "Vquad_polynomial_3of4.h"
#include "Vquad_polynomial_quad_polynomial.h"
#include "tb/dut/surface_point_dut.h"

namespace shading::tb {

// Pins of quad_polynomial; Top is the build for one lane. The only file that includes
// Vquad_polynomial*.h.
template <typename Top>
class QuadPolynomialBuildDut : public SurfacePointDut<Top> {
 public:
  static constexpr int kLatency = Vquad_polynomial_quad_polynomial::Latency;
};

// The only lane of one, and the last of four: parameters as in tests/unit/intensity/CMakeLists.txt.
using QuadPolynomialDut = QuadPolynomialBuildDut<Vquad_polynomial>;
using QuadPolynomialLane3Of4Dut = QuadPolynomialBuildDut<Vquad_polynomial_3of4>;

}  // namespace shading::tb
