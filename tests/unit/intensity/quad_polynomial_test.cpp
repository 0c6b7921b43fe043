// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/quad_polynomial.h"

#include <gtest/gtest.h>

#include <vector>

#include "tb/dut/quad_polynomial_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/intensity/point_stimulus.h"

namespace shading {
namespace {

constexpr int kSpans = 10000;
using Dut = tb::QuadPolynomialDut;

SurfacePoint PointOf(const std::array<int64_t, 6>& codes, int x, int y) {
  const auto raw = [&](size_t i) { return IntensityAcc::FromRaw(codes[i] * kOneCode); };
  return {{raw(0), raw(1), raw(2), raw(3), raw(4), raw(5)}, x, y};
}

class QuadPolynomialFlow : public testing::TestWithParam<Flow> {};

TEST_P(QuadPolynomialFlow, RtlMatchesModel) {
  ExpectSamePointCodes<QuadPolynomial, Dut>(PatternOf(GetParam(), 1), kSpans, 0, 1);
}

TEST_P(QuadPolynomialFlow, LastLaneOfFourMatchesModel) {
  ExpectSamePointCodes<QuadPolynomial, tb::QuadPolynomialLane3Of4Dut>(PatternOf(GetParam(), 1),
                                                                      kSpans, 3, 4);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, QuadPolynomialFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(QuadPolynomial, ContractMatchesRtl) {
  const UnitContract& contract = QuadPolynomial::kContract;
  EXPECT_EQ(Dut::kLatency, contract.latency_cycles);
  Dut rtl;
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

TEST(QuadPolynomial, ModelMatchesThePolynomial) { ExpectPolynomialCodes<QuadPolynomial>(3000); }

TEST(QuadPolynomial, ModelWithinErrorBound) {
  const double bound = PointBound(kBoundedOffset, kBoundedOffset);
  EXPECT_LE(bound, QuadPolynomial::kContract.max_error_ulp);
  const double worst = WorstPointDrift<QuadPolynomial>(20000);
  RecordProperty("worst_error_microcodes", static_cast<int>(worst * 1e6));
  EXPECT_LE(worst, bound);
  EXPECT_GT(worst, 0.99 * bound) << "the search is blind";
}

// Codes of RTL and model along a span, which must agree.
std::vector<int> Codes(const SurfacePoint& point, int length) {
  Dut rtl;
  QuadPolynomial model(point);
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

TEST(QuadPolynomial, EveryTermCounts) {
  // 2 x^2, 3 y^2, -x y, 5 x, -7 y, 11 at y = -4, x = -2..1: 8 + 48 - 8 - 10 + 28 + 11, ...
  EXPECT_EQ(Codes(PointOf({2, 3, -1, 5, -7, 11}, -2, -4), 4), (std::vector<int>{77, 80, 87, 98}));
}

TEST(QuadPolynomial, ClampsOnBothSides) {
  // x^2 - 4 and 260 - x^2.
  EXPECT_EQ(Codes(PointOf({1, 0, 0, 0, 0, -4}, -3, 9), 7), (std::vector<int>{5, 0, 0, 0, 0, 0, 5}));
  EXPECT_EQ(Codes(PointOf({-1, 0, 0, 0, 0, 260}, -3, 9), 7),
            (std::vector<int>{251, 255, 255, 255, 255, 255, 251}));
}

TEST(QuadPolynomial, FarCornersOfTheScreen) {
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
      EXPECT_EQ(Codes({bowl, x, y}, 1), std::vector<int>{253});
      EXPECT_EQ(Codes({saddle, x, y}, 1), std::vector<int>{x == y ? 255 : 0});
    }
  }
}

TEST(QuadPolynomial, LoadWinsOverStepAndIdleHolds) {
  Dut rtl;
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

}  // namespace
}  // namespace shading
