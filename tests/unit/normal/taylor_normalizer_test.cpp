// SPDX-License-Identifier: Apache-2.0
#include "model/normal/taylor_normalizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tb/dut/taylor_normalizer_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {
namespace {

using Dut = tb::TaylorNormalizerDut;
using Normal = std::array<Quantity, 3>;

constexpr int64_t kOne = int64_t{1} << Quantity::kFraction;

Normal Raw(int64_t x, int64_t y, int64_t z) {
  return {Quantity::FromRaw(x), Quantity::FromRaw(y), Quantity::FromRaw(z)};
}

Normal AnyNormal(std::mt19937& random) {
  if (random() % 2) return NormalOf(RandomLength(std::ldexp(1, -9), random), random);
  return {AnyQuantity(random), AnyQuantity(random), AnyQuantity(random)};
}

class TaylorNormalizerFlow : public testing::TestWithParam<Flow> {};

TEST_P(TaylorNormalizerFlow, RtlMatchesModel) {
  std::mt19937 random(1);
  ExpectSameStream<Dut>(
      PatternOf(GetParam(), 2), 500000, [&] { return AnyNormal(random); }, TaylorNormalizer::Of,
      SameNormal);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, TaylorNormalizerFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(TaylorNormalizer, ContractMatchesRtl) {
  ExpectPipelineTiming<Dut>(TaylorNormalizer::kContract, Raw(0, 0, kOne));
}

// Of the worst component, in ulp of S1.24, against the polynomial.
double Error(const Normal& m) {
  const long double norm = LengthOf(m), d = norm * norm - 1;
  const long double factor = 1 - d / 2 + d * d * 3 / 8;
  const PixelNormal n = TaylorNormalizer::Of(m);
  long double worst = 0;
  for (size_t i = 0; i < 3; ++i) {
    const long double ideal = std::ldexp(m[i].raw() * factor, 24 - Quantity::kFraction);
    worst = std::max(worst, std::abs(static_cast<long double>(n[i].raw()) - ideal));
  }
  return static_cast<double>(worst);
}

TEST(TaylorNormalizer, ModelWithinErrorBound) {
  std::mt19937 random(1);
  const double longest = 1 + std::ldexp(1, -9);
  double worst = 0;
  Normal at = NormalOf(1, random);
  const auto attempt = [&](const Normal& m) {
    if (LengthOf(m) > longest) return;
    const double error = Error(m);
    if (error > worst) {
      worst = error;
      at = m;
    }
  };
  for (int i = 0; i < 1000000; ++i) attempt(NormalOf(RandomLength(1e-3, random), random));
  for (int i = 0; i < 1000000; ++i) {
    Normal m = at;
    for (Quantity& c : m) c = Quantity::Wrap(c.raw() + AnyOctave(30, random));
    attempt(m);
  }
  RecordProperty("worst_error_milliulp", static_cast<int>(worst * 1000));
  EXPECT_LT(worst, TaylorNormalizer::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.55) << "the search is blind";
}

// Length of the middle of a span whose unit ends enclose the angle, and the loss of light there,
// in codes, for L and H along the normal. Shorter than unit everywhere, most in the middle.
struct Loss {
  int degrees;
  double length, diffuse, n8, n32, n128;
};

TEST(TaylorNormalizer, LossOfLightIsAsThePageSays) {
  constexpr Loss kPage[] = {
      {10, 1.2e-7, 0.00, 0.00, 0.00, 0.00},         {20, 8.7e-6, 0.00, 0.02, 0.07, 0.28},
      {30, 9.6e-5, 0.02, 0.20, 0.79, 3.13},         {45, 1.0e-3, 0.27, 2.12, 8.36, 31.82},
      {60, 5.4e-3, 1.38, 10.86, 40.73, 127.88},     {90, 0.050, 12.71, 85.58, 205.31, 254.63},
      {120, 0.207, 52.79, 215.14, 254.85, 255.00},  {150, 0.536, 136.67, 254.45, 255.00, 255.00},
      {170, 0.837, 213.54, 255.00, 255.00, 255.00},
  };
  for (const Loss& page : kPage) {
    SCOPED_TRACE(page.degrees);
    const double half = page.degrees * std::acos(-1.0) / 360;
    const Normal m = {Quantity{}, Quantity{}, Quantity::Round(std::cos(half))};
    const double length = TaylorNormalizer::Of(m)[2].ToReal();
    const auto codes = [&](int n) { return 255 * (1 - std::pow(length, n)); };
    EXPECT_NEAR(1 - length, page.length, 0.06 * page.length);
    EXPECT_NEAR(codes(1), page.diffuse, 0.006);
    EXPECT_NEAR(codes(8), page.n8, 0.006);
    EXPECT_NEAR(codes(32), page.n32, 0.006);
    EXPECT_NEAR(codes(128), page.n128, 0.006);
  }
}

TEST(TaylorNormalizer, NeverLongerThanUnitNorFallingWithLength) {
  double last = 0;
  for (int i = 1; i <= 4096; ++i) {
    const double length = TaylorNormalizer::Of(Raw(0, 0, i * (kOne >> 12)))[2].ToReal();
    ASSERT_GE(length, last);
    ASSERT_LE(length, 1);
    last = length;
  }
}

TEST(TaylorNormalizer, ZeroAndUnitAreExact) {
  EXPECT_EQ(TaylorNormalizer::Of(Raw(0, 0, 0)), PixelNormal{});
  EXPECT_EQ(TaylorNormalizer::Of(Raw(0, -kOne, 0))[1].raw(), -(1 << 24));
  // |M|^2 = 1/4: 1 + 3/8 + 27/128 over 2.
  EXPECT_DOUBLE_EQ(TaylorNormalizer::Of(Raw(kOne / 2, 0, 0))[0].ToReal(), 203.0 / 256);
}

TEST(TaylorNormalizer, ShortestNormalsGrowByFifteenEighths) {
  EXPECT_NEAR(TaylorNormalizer::Of(Raw(0, kOne >> 9, 0))[1].ToReal() * 512, 1.875, 1e-4);
}

TEST(TaylorNormalizer, LengthSlightlyAboveOne) {
  EXPECT_NEAR(TaylorNormalizer::Of(Raw(0, 0, kOne + (kOne >> 9)))[2].ToReal(), 1, 1e-7);
}

TEST(TaylorNormalizer, TooLongCountsAsRootTwo) {
  const PixelNormal n = TaylorNormalizer::Of(Raw(2 * kOne - 1, -2 * kOne, kOne));
  EXPECT_NEAR(n[0].ToReal(), 2 * 0.875, 1e-6);
  EXPECT_NEAR(n[1].ToReal(), -2 * 0.875, 1e-6);
}

}  // namespace
}  // namespace shading
