// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_third_difference.h"

#include "tb/dut/quad_third_difference_dut.h"
#include "tests/unit/intensity/quad_form_suite.h"

namespace shading {
namespace {

struct ThirdDifferenceForm {
  using Model = QuadThirdDifference;
  using Dut = tb::QuadThirdDifferenceDut;

  // Lagrange through I(0), I(1), I(2).
  static Int128 Value(const ChannelSeed& seed, int t) {
    const Int128 first = seed.first.raw(), second = seed.second.raw();
    const Int128 third = second + seed.difference.raw() + seed.curvature.raw();
    return CurveAt(first, second - first, third - 2 * second + first, t);
  }
  static uint8_t Code(const ChannelSeed& seed, int t) { return CodeOf(Value(seed, t)); }
  static ChannelSeed Seed(const RealCurve& curve) { return curve.SeedOfThreeValues(); }
  static RealCurve Extreme(double sign) {
    const double half_ulp = sign * AlmostHalfUlp();
    return RealCurve::Through3(10 + half_ulp, 10.125 - half_ulp, 10.375 + half_ulp);
  }
  static double Bound(int t) {
    const double square = static_cast<double>(t) * t;
    return std::ldexp(std::max(1.0, 2 * square - 4 * t + 1), -27);
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(QuadThirdDifference, QuadForm, ThirdDifferenceForm);

}  // namespace
}  // namespace shading
