// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_surface.h"

#include "tb/dut/quad_surface_dut.h"
#include "tests/unit/intensity/quad_form_suite.h"

namespace shading {
namespace {

struct Surface5 {
  using Model = QuadSurface;
  using Dut = tb::QuadSurfaceDut;

  // From I(0), I(1) and 2A.
  static Int128 Value(const ChannelSeed& seed, int t) {
    const Int128 first = seed.first.raw(), second = seed.second.raw();
    return CurveAt(first, second - first, seed.curvature.raw(), t);
  }
  static uint8_t Code(const ChannelSeed& seed, int t) { return CodeOf(Value(seed, t)); }
  static ChannelSeed Seed(const RealCurve& curve) { return curve.SeedOfTwoValues(); }

  static RealCurve Extreme(double sign) {
    const double half_ulp = sign * AlmostHalfUlp();
    return RealCurve::Through(10 - half_ulp, 10.125 + half_ulp, std::ldexp(1, -16) + half_ulp);
  }
  static double Bound(int t) {
    return std::ldexp(t == 0 ? 1 : static_cast<double>(t) * t + t - 1, -27);
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(QuadSurface, QuadForm, Surface5);

}  // namespace
}  // namespace shading
