// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_step.h"

#include "tb/dut/quad_step_dut.h"
#include "tests/unit/intensity/quad_form_suite.h"

namespace shading {
namespace {

struct StepForm {
  using Model = QuadStep;
  using Dut = tb::QuadStepDut;

  static Int128 Value(const ChannelSeed& seed, int t) { return CurveAt(seed, t); }
  static uint8_t Code(const ChannelSeed& seed, int t) { return CodeOf(Value(seed, t)); }
  static ChannelSeed Seed(const RealCurve& curve) { return curve.SeedOfDifferenceAndA(); }
  // I(0), I(1) - I(0) and A lie half an ulp, less a 65536th, from their seeds, all on one side.
  static RealCurve Extreme(double sign) {
    const double off = sign * std::ldexp(0.5 - std::ldexp(1, -16), -26);
    return RealCurve::Through(10 - off, 10.125 - 2 * off, std::ldexp(1, -16) - off);
  }
  static double Bound(int t) { return std::ldexp(static_cast<double>(t) * t + 1, -27); }
};

INSTANTIATE_TYPED_TEST_SUITE_P(QuadStep, QuadForm, StepForm);

// I(t) - I(t-1) = t codes modulo the register: one bit of the pixel number after the other.
TEST(QuadStep, EveryBitOfThePixelNumberCounts) {
  tb::QuadStepDut rtl;
  const ChannelSeed seed = Curve(0, kOneCode, kOneCode);
  rtl.Cycle(true, false, seed);
  for (int t = 0; t < kMaxScreen; ++t) {
    ASSERT_EQ(rtl.code(), CodeOf(static_cast<Int128>(kOneCode) * (t * (t + 1) / 2))) << t;
    rtl.Cycle(false, true, seed);
  }
}

}  // namespace
}  // namespace shading
