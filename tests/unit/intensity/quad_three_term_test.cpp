// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_three_term.h"

#include "tb/dut/quad_three_term_dut.h"
#include "tests/unit/intensity/quad_form_suite.h"

namespace shading {
namespace {

struct ThreeTermForm {
  using Model = QuadThreeTerm;
  using Dut = tb::QuadThreeTermDut;

  // From I(0), I(1), I(2) and 4A. With s = t/2, rounded down:
  //   t even  (1 - s) I(0) + s I(2) + s (s - 1) 4A
  //   t odd   -s I(0) + I(1) + s I(2) + s^2 4A
  static Int128 Value(const ChannelSeed& seed, int t) {
    const Int128 first = seed.first.raw(), second = seed.second.raw(),
                 curvature = seed.curvature.raw();
    const Int128 third = second + seed.difference.raw() + curvature;
    const int64_t s = t / 2;
    return t % 2 ? second + s * (third - first) + 2 * curvature * (s * s)
                 : first + s * (third - first) + 2 * curvature * (s * (s - 1));
  }
  static uint8_t Code(const ChannelSeed& seed, int t) { return CodeOf(Value(seed, t)); }
  static ChannelSeed Seed(const RealCurve& curve) { return curve.SeedOfThreeValues(); }
  // I(0), I(1) and A; I(2) = 2A + 2 I(1) - I(0) is then 5/2 ulps less five 65536ths from its seed.
  static RealCurve Extreme(double sign) {
    const double half_ulp = sign * AlmostHalfUlp();
    return RealCurve::Through(10 - half_ulp, 10.125 + half_ulp, std::ldexp(1, -16) + half_ulp);
  }
  static double Bound(int t) {
    const double square = static_cast<double>(t) * t;
    return std::ldexp(t == 0 ? 1 : t % 2 ? square - t + 1 : square - t - 1, -27);
  }
};

INSTANTIATE_TYPED_TEST_SUITE_P(QuadThreeTerm, QuadForm, ThreeTermForm);

}  // namespace
}  // namespace shading
