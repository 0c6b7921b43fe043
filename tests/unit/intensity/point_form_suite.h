// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "tests/unit/flows.h"
#include "tests/unit/intensity/point_stimulus.h"

namespace shading {

inline SurfacePoint PointOf(const std::array<int64_t, 6>& codes, int x, int y) {
  const auto raw = [&](size_t i) { return IntensityAcc::FromRaw(codes[i] * kOneCode); };
  return {{raw(0), raw(1), raw(2), raw(3), raw(4), raw(5)}, x, y};
}

// The tests of a unit that evaluates every pixel from the coefficients. Form says which it is:
//   Model
//   Dut, LaneDut       its pins with one lane, and as lane 3 of 4
template <typename Form>
class PointForm : public testing::Test {
 protected:
  static void ExpectSame(Flow flow) {
    constexpr int kSpans = 10000;
    using Model = typename Form::Model;
    ExpectSamePointCodes<Model, typename Form::Dut>(PatternOf(flow, 1), kSpans, 0, 1);
    ExpectSamePointCodes<Model, typename Form::LaneDut>(PatternOf(flow, 1), kSpans, 3, 4);
  }

  // Codes of RTL and model along a span, which must agree.
  static std::vector<int> Codes(const SurfacePoint& point, int length) {
    typename Form::Dut rtl;
    typename Form::Model model(point);
    rtl.Cycle(true, false, point);
    std::vector<int> codes;
    for (int t = 0; t < length; ++t) {
      EXPECT_EQ(rtl.code(), model.code());
      codes.push_back(rtl.code());
      rtl.Cycle(false, true, {});
      model.Step();
    }
    return codes;
  }
};

TYPED_TEST_SUITE_P(PointForm);

TYPED_TEST_P(PointForm, RtlMatchesModelAlways) { this->ExpectSame(Flow::kAlways); }
TYPED_TEST_P(PointForm, RtlMatchesModelOneInFour) { this->ExpectSame(Flow::kOneInFour); }
TYPED_TEST_P(PointForm, RtlMatchesModelRandom) { this->ExpectSame(Flow::kRandom); }

TYPED_TEST_P(PointForm, ContractMatchesRtl) {
  const UnitContract& contract = TypeParam::Model::kContract;
  EXPECT_EQ(TypeParam::Dut::kLatency, contract.latency_cycles);
  typename TypeParam::Dut rtl;
  const SurfacePoint one = PointOf({0, 0, 0, 0, 0, 17}, 0, 0);
  const SurfacePoint two = PointOf({0, 0, 0, 0, 0, 200}, 0, 0);
  rtl.Cycle(true, false, one);
  int cycles = 1;
  rtl.Cycle(true, false, two);
  for (; rtl.code() != 200 && cycles < 8; ++cycles) rtl.Cycle(false, false, one);
  EXPECT_EQ(cycles, contract.latency_cycles);
  int seen = 0;
  for (int load = 0; load < 8; ++load) {
    rtl.Cycle(true, true, load % 2 ? two : one);
    seen += rtl.code() == (load % 2 ? 200 : 17);
  }
  EXPECT_EQ(seen, 8 / contract.interval_cycles);
}

TYPED_TEST_P(PointForm, ModelMatchesThePolynomial) {
  ExpectPolynomialCodes<typename TypeParam::Model>(3000);
}

TYPED_TEST_P(PointForm, ModelWithinErrorBound) {
  const double bound = PointBound(kBoundedOffset, kBoundedOffset);
  EXPECT_LE(bound, TypeParam::Model::kContract.max_error_ulp);
  const double worst = WorstPointDrift<typename TypeParam::Model>(20000);
  testing::Test::RecordProperty("worst_error_microcodes", static_cast<int>(worst * 1e6));
  EXPECT_LE(worst, bound);
  EXPECT_GT(worst, 0.99 * bound) << "the search is blind";
}

TYPED_TEST_P(PointForm, EveryTermCounts) {
  // 2 x^2, 3 y^2, -x y, 5 x, -7 y, 11 at y = -4, x = -2..1: 8 + 48 - 8 - 10 + 28 + 11, ...
  EXPECT_EQ(this->Codes(PointOf({2, 3, -1, 5, -7, 11}, -2, -4), 4),
            (std::vector<int>{77, 80, 87, 98}));
}

TYPED_TEST_P(PointForm, ClampsOnBothSides) {
  // x^2 - 4 and 260 - x^2.
  EXPECT_EQ(this->Codes(PointOf({1, 0, 0, 0, 0, -4}, -3, 9), 7),
            (std::vector<int>{5, 0, 0, 0, 0, 0, 5}));
  EXPECT_EQ(this->Codes(PointOf({-1, 0, 0, 0, 0, 260}, -3, 9), 7),
            (std::vector<int>{251, 255, 255, 255, 255, 255, 251}));
}

TYPED_TEST_P(PointForm, FarCornersOfTheScreen) {
  // A x^2 = 224.9 codes and B y^2 = 28.0 at 4095; C x y takes as much away as both add.
  const auto scaled = [](int64_t a, int64_t b, int64_t c) {
    return Surface{IntensityAcc::FromRaw(a),
                   IntensityAcc::FromRaw(b),
                   IntensityAcc::FromRaw(c),
                   {},
                   {},
                   IntensityAcc::FromRaw(kOneCode / 2)};
  };
  const int most = kMaxScreen - 1;
  const Surface bowl = scaled(900, 112, 0), saddle = scaled(900, 112, 1012);
  for (const int x : {-most, most}) {
    for (const int y : {-most, most}) {
      EXPECT_EQ(this->Codes({bowl, x, y}, 1), std::vector<int>{253});
      EXPECT_EQ(this->Codes({saddle, x, y}, 1), std::vector<int>{x == y ? 255 : 0});
    }
  }
}

TYPED_TEST_P(PointForm, LoadWinsOverStepAndIdleHolds) {
  typename TypeParam::Dut rtl;
  const SurfacePoint noise = PointOf({99, 98, 97, 96, 95, 94}, 5, 6);
  rtl.Cycle(true, true, PointOf({1, 0, 0, 0, 0, 10}, 0, 0));
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, false, noise);
  EXPECT_EQ(rtl.code(), 10);
  rtl.Cycle(false, true, noise);
  EXPECT_EQ(rtl.code(), 11);
  rtl.Cycle(true, true, PointOf({0, 0, 0, 0, 0, 20}, 0, 0));
  EXPECT_EQ(rtl.code(), 20);
}

REGISTER_TYPED_TEST_SUITE_P(PointForm, RtlMatchesModelAlways, RtlMatchesModelOneInFour,
                            RtlMatchesModelRandom, ContractMatchesRtl, ModelMatchesThePolynomial,
                            ModelWithinErrorBound, EveryTermCounts, ClampsOnBothSides,
                            FarCornersOfTheScreen, LoadWinsOverStepAndIdleHolds);

}  // namespace shading
