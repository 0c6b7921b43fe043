// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_midpoint.h"

#include "tb/dut/quad_midpoint_dut.h"
#include "tests/unit/intensity/quad_form_suite.h"

namespace shading {
namespace {

struct MidpointForm {
  using Model = QuadMidpoint;
  using Dut = tb::QuadMidpointDut;

  static Int128 Value(const ChannelSeed& seed, int t) { return CurveAt(seed, t); }
  // Odd pixels are known modulo 512 codes: the residue in -128..383.
  static uint8_t Code(const ChannelSeed& seed, int t) {
    const Int128 value = Value(seed, t), least = -128 * kOneCode, turn = 512 * kOneCode;
    return CodeOf(t % 2 ? value - turn * FloorDivide<Int128>(value - least, turn) : value);
  }
  static ChannelSeed Seed(const RealCurve& curve) { return curve.SeedOfDifferenceAndA(); }
  static RealCurve Extreme(double sign) {
    const double half_ulp = sign * AlmostHalfUlp();
    return RealCurve::FromDifferences(10 + half_ulp, 0.125 + half_ulp,
                                      std::ldexp(1, -16) + half_ulp);
  }
  static double Bound(int t) { return std::ldexp(static_cast<double>(t) * t + 1, -27); }
};

// 2A = 1 ulp: A is half an ulp, and so are the halved sums of (6).
TEST(QuadMidpoint, OddCurvatureIsHalvedExactly) {
  tb::QuadMidpointDut rtl;
  // 3 codes and -1, -1, 0, 2, 5, ... ulps.
  const ChannelSeed seed = Curve(3 * kOneCode - 1, 3 * kOneCode - 1, 1);
  QuadMidpoint model(seed);
  rtl.Cycle(true, false, seed);
  for (int t = 0; t < 8; ++t) {
    EXPECT_EQ(rtl.code(), t < 2 ? 2 : 3) << "pixel " << t;
    EXPECT_EQ(model.code(), t < 2 ? 2 : 3) << "pixel " << t;
    rtl.Cycle(false, true, seed);
    model.Step();
  }
}

INSTANTIATE_TYPED_TEST_SUITE_P(QuadMidpoint, QuadForm, MidpointForm);

}  // namespace
}  // namespace shading
