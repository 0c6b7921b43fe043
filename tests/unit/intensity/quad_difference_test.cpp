// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_difference.h"

#include "tb/dut/quad_difference_dut.h"
#include "tests/unit/intensity/quad_form_suite.h"

namespace shading {
namespace {

struct DifferenceForm {
  using Model = QuadDifference;
  using Dut = tb::QuadDifferenceDut;

  static Int128 Value(const ChannelSeed& seed, int t) { return CurveAt(seed, t); }
  static uint8_t Code(const ChannelSeed& seed, int t) { return CodeOf(Value(seed, t)); }
  static ChannelSeed Seed(const RealCurve& curve) { return curve.SeedOfDifferences(); }
  static RealCurve Extreme(double sign) {
    const double half_ulp = sign * AlmostHalfUlp();
    return RealCurve::FromDifferences(10 + half_ulp, 0.125 + half_ulp,
                                      std::ldexp(1, -16) + half_ulp / 2);
  }
  static double Bound(int t) {
    return std::ldexp(1 + t + static_cast<double>(t) * (t - 1) / 2, -27);
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(QuadDifference, QuadForm, DifferenceForm);

}  // namespace
}  // namespace shading
