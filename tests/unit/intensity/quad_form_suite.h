// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/unit/flows.h"
#include "tests/unit/intensity/real_curve.h"

namespace shading {

// The tests that every exact second-order unit passes. Form says which unit it is and what the
// test may know of it:
//   Model, Dut
//   Value(seed, t)     2^26 I(t) in closed form, without a recurrence or a register that wraps
//   Code(seed, t)      the code of it
//   Seed(curve)        the seed that rounds what the form starts from
//   Extreme(sign)      a curve whose roundings are at their extremes and add up at every pixel
//   Bound(t)           codes by which the roundings move pixel t at most
template <typename Form>
class QuadForm : public testing::Test {
 protected:
  using Model = typename Form::Model;
  using Dut = typename Form::Dut;

  static void ExpectSame(Flow flow) { ExpectSameCodes<Model, Dut>(PatternOf(flow, 1), 5000, 2); }
  static double DriftOf(const ChannelSeed& seed, const RealCurve& curve, int t) {
    return Drift(Form::Value(seed, t), curve, t);
  }

  // Codes of RTL and model along a span, which must agree.
  static std::vector<int> Codes(Dut* rtl, const ChannelSeed& seed, int length) {
    Model model(seed);
    rtl->Cycle(true, false, seed);
    std::vector<int> codes;
    for (int t = 0; t < length; ++t) {
      EXPECT_EQ(rtl->code(), model.code());
      codes.push_back(rtl->code());
      if (t + 1 == length) break;
      rtl->Cycle(false, true, seed);
      model.Step();
    }
    return codes;
  }
};

TYPED_TEST_SUITE_P(QuadForm);

TYPED_TEST_P(QuadForm, RtlMatchesModelAlways) { this->ExpectSame(Flow::kAlways); }
TYPED_TEST_P(QuadForm, RtlMatchesModelOneInFour) { this->ExpectSame(Flow::kOneInFour); }
TYPED_TEST_P(QuadForm, RtlMatchesModelRandom) { this->ExpectSame(Flow::kRandom); }

TYPED_TEST_P(QuadForm, ContractMatchesRtl) {
  ExpectTiming<typename TypeParam::Dut>(TypeParam::Model::kContract,
                                        Curve(17 * kOneCode, 18 * kOneCode, 0),
                                        Curve(200 * kOneCode, 0, kOneCode));
}

TYPED_TEST_P(QuadForm, ModelMatchesClosedForm) {
  std::mt19937 random(1);
  for (int span = 0; span < 3000; ++span) {
    const int length = RandomLength(random);
    const ChannelSeed seed = RandomSeed(length, random);
    typename TypeParam::Model model(seed);
    for (int t = 0; t < length; ++t, model.Step()) {
      ASSERT_EQ(model.code(), TypeParam::Code(seed, t)) << "span " << span << " pixel " << t;
    }
  }
}

TYPED_TEST_P(QuadForm, ModelWithinErrorBound) {
  std::mt19937 random(1);
  double worst = 0;
  for (int i = 0; i < 1000; ++i) {
    const RealCurve curve = RandomCurve(random);
    const ChannelSeed seed = TypeParam::Seed(curve);
    typename TypeParam::Model model(seed);
    for (int t = 0; t < kBoundedLength; ++t, model.Step()) {
      const double drift = this->DriftOf(seed, curve, t);
      ASSERT_LE(drift, TypeParam::Bound(t)) << "curve " << i << " pixel " << t;
      ASSERT_EQ(model.code(), TypeParam::Code(seed, t));
      const double ideal = std::clamp(static_cast<double>(curve.At(t)) - 0.5, 0.0, 255.0);
      ASSERT_LE(std::abs(model.code() - ideal), 0.5 + drift + 1e-9);
      worst = std::max(worst, drift);
    }
  }
  const auto last_drift = [&](const RealCurve& curve) {
    return this->DriftOf(TypeParam::Seed(curve), curve, kBoundedLength - 1);
  };
  for (int i = 0; i < 100000; ++i) worst = std::max(worst, last_drift(RandomCurve(random)));
  worst = std::max(worst, WorstDrift(last_drift, random));
  const double bound = TypeParam::Bound(kBoundedLength - 1);
  testing::Test::RecordProperty("worst_error_microcodes", static_cast<int>(worst * 1e6));
  testing::Test::RecordProperty("worst_permille_of_bound", static_cast<int>(1000 * worst / bound));
  EXPECT_LE(bound, TypeParam::Model::kContract.max_error_ulp);
  EXPECT_GT(bound, 0.99 * TypeParam::Model::kContract.max_error_ulp);
  EXPECT_LE(worst, bound);
  EXPECT_GT(worst, 0.999 * bound) << "the search is blind";
}

TYPED_TEST_P(QuadForm, RoundingErrorsAtTheirExtremesStayInBound) {
  for (const double sign : {1.0, -1.0}) {
    const RealCurve curve = TypeParam::Extreme(sign);
    const ChannelSeed seed = TypeParam::Seed(curve);
    for (int t = 1; t < kMaxScreen; ++t) {
      ASSERT_LE(this->DriftOf(seed, curve, t), TypeParam::Bound(t)) << "pixel " << t;
      ASSERT_GT(this->DriftOf(seed, curve, t), 0.999 * TypeParam::Bound(t)) << "pixel " << t;
    }
  }
}

TYPED_TEST_P(QuadForm, ClampsOnBothSides) {
  typename TypeParam::Dut rtl;
  // -1, 0, 3, 8: and 256, 255, 252.
  EXPECT_EQ(this->Codes(&rtl, Curve(-kOneCode, 0, 2 * kOneCode), 4),
            (std::vector<int>{0, 0, 3, 8}));
  EXPECT_EQ(this->Codes(&rtl, Curve(256 * kOneCode, 255 * kOneCode, -2 * kOneCode), 3),
            (std::vector<int>{255, 255, 252}));
  // -86, 127.5, 341 and back: the limits of what is shown.
  EXPECT_EQ(this->Codes(&rtl, Curve(-86 * kOneCode, 255 * kHalfCode, 0), 3),
            (std::vector<int>{0, 127, 255}));
  EXPECT_EQ(this->Codes(&rtl, Curve(341 * kOneCode, 255 * kHalfCode, 0), 3),
            (std::vector<int>{255, 127, 0}));
  // -86, 341, -86: the steepest that a pixel can show.
  EXPECT_EQ(this->Codes(&rtl, Curve(-86 * kOneCode, 341 * kOneCode, -427 * kOneCode), 2),
            (std::vector<int>{0, 255}));
}

TYPED_TEST_P(QuadForm, HighlightHasAMaximumInsideTheSpan) {
  typename TypeParam::Dut rtl;
  // 255 - (t - 3)^2.
  EXPECT_EQ(this->Codes(&rtl, Curve(246 * kOneCode, 251 * kOneCode, -2 * kOneCode), 7),
            (std::vector<int>{246, 251, 254, 255, 254, 251, 246}));
}

TYPED_TEST_P(QuadForm, LastPixelOfLongestSpan) {
  typename TypeParam::Dut rtl;
  // t^2 / 65536 codes: 255.875 at t = 4095.
  const int64_t a = kOneCode >> 16;
  const std::vector<int> codes = this->Codes(&rtl, Curve(0, a, 2 * a), kMaxScreen);
  EXPECT_EQ(codes.back(), 255);
  EXPECT_EQ(codes[4087], 254);  // 254.88
  EXPECT_EQ(codes[4088], 255);  // 255.0
}

TYPED_TEST_P(QuadForm, SinglePixelRunsBackToBack) {
  typename TypeParam::Dut rtl;
  for (int code = 0; code <= 255; ++code) {
    EXPECT_EQ(this->Codes(&rtl, Curve(code * kOneCode, kMostAcc, kLeastAcc), 1),
              std::vector<int>{code});
  }
}

TYPED_TEST_P(QuadForm, WrapIsNeverShown) {
  typename TypeParam::Dut rtl;
  // 0, 300, 600, ...: the look-ahead wraps while the second pixel, the last one, is shown.
  EXPECT_EQ(this->Codes(&rtl, Curve(0, 300 * kOneCode, 0), 2), (std::vector<int>{0, 255}));
  EXPECT_EQ(this->Codes(&rtl, Curve(7 * kOneCode, 8 * kOneCode, 0), 3),
            (std::vector<int>{7, 8, 9}));
}

TYPED_TEST_P(QuadForm, LoadWinsOverStepAndIdleHolds) {
  typename TypeParam::Dut rtl;
  const ChannelSeed noise = Curve(99 * kOneCode, 98 * kOneCode, 97 * kOneCode);
  const auto code = [&](bool load, bool step, const ChannelSeed& seed) {
    rtl.Cycle(load, step, seed);
    return rtl.code();
  };
  // 10, 15, 22, 31; then spans that start at each pixel of the one before.
  for (int left = 0; left < 4; ++left) {
    SCOPED_TRACE(left);
    EXPECT_EQ(code(true, true, Curve(10 * kOneCode, 15 * kOneCode, 2 * kOneCode)), 10);
    const int codes[] = {10, 15, 22, 31};
    for (int t = 1; t <= left; ++t) {
      EXPECT_EQ(code(false, false, noise), codes[t - 1]);
      EXPECT_EQ(code(false, true, noise), codes[t]);
    }
    EXPECT_EQ(code(false, false, noise), codes[left]);
    EXPECT_EQ(code(true, true, Curve(20 * kOneCode, 22 * kOneCode, 0)), 20);
    EXPECT_EQ(code(false, true, noise), 22);
    EXPECT_EQ(code(false, true, noise), 24);
  }
}

REGISTER_TYPED_TEST_SUITE_P(QuadForm, RtlMatchesModelAlways, RtlMatchesModelOneInFour,
                            RtlMatchesModelRandom, ContractMatchesRtl, ModelMatchesClosedForm,
                            ModelWithinErrorBound, RoundingErrorsAtTheirExtremesStayInBound,
                            ClampsOnBothSides, HighlightHasAMaximumInsideTheSpan,
                            LastPixelOfLongestSpan, SinglePixelRunsBackToBack, WrapIsNeverShown,
                            LoadWinsOverStepAndIdleHolds);

}  // namespace shading
