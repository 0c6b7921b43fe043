// SPDX-License-Identifier: Apache-2.0
#include "model/normal/phong_direct.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tb/dut/phong_direct_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {
namespace {

using Dut = tb::PhongDirectDut;
using Normal = std::array<Quantity, 3>;

constexpr int64_t kOne = int64_t{1} << Quantity::kFraction;
const double kShortest = std::ldexp(1, -9);

Normal Raw(int64_t x, int64_t y, int64_t z) {
  return {Quantity::FromRaw(x), Quantity::FromRaw(y), Quantity::FromRaw(z)};
}

// Anything, also what no span contains; or a normal of a span.
Normal AnyNormal(std::mt19937& random) {
  if (random() % 2) return NormalOf(RandomLength(kShortest, random), random);
  return {AnyQuantity(random), AnyQuantity(random), AnyQuantity(random)};
}

class PhongDirectFlow : public testing::TestWithParam<Flow> {};

TEST_P(PhongDirectFlow, RtlMatchesModel) {
  std::mt19937 random(1);
  ExpectSameStream<Dut>(
      PatternOf(GetParam(), 2), 500000, [&] { return AnyNormal(random); }, PhongDirect::Of,
      SameNormal);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, PhongDirectFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(PhongDirect, ContractMatchesRtl) {
  ExpectPipelineTiming<Dut>(PhongDirect::kContract, Raw(0, 0, kOne));
}

// Against M / |M| in long double.
struct Errors {
  double component = 0;  // ulp of S1.24
  double direction = 0;  // radians
  double length = 0;     // less its allowance for short normals
};

Errors ErrorsOf(const Normal& m) {
  const long double norm = LengthOf(m);
  const PixelNormal n = PhongDirect::Of(m);
  long double u[3], v[3], length = 0, cross = 0;
  Errors errors;
  for (size_t i = 0; i < 3; ++i) {
    u[i] = std::ldexp(static_cast<long double>(m[i].raw()), -38) / norm;
    v[i] = std::ldexp(static_cast<long double>(n[i].raw()), -24);
    length += v[i] * v[i];
    errors.component =
        std::max(errors.component, static_cast<double>(std::ldexp(std::abs(u[i] - v[i]), 24)));
  }
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    cross += (u[j] * v[k] - u[k] * v[j]) * (u[j] * v[k] - u[k] * v[j]);
  }
  length = std::sqrt(length);
  errors.direction = static_cast<double>(std::sqrt(cross) / length);
  errors.length = static_cast<double>(std::abs(length - 1) - std::pow(2.0L, -29.1L) / norm);
  return errors;
}

// The worst normals of lengths from `shortest` to `longest`, by random trials and hill climbing.
Errors Search(double shortest, double longest, double Errors::*goal, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  Errors worst;
  Normal at = NormalOf(longest, random);
  const auto attempt = [&](const Normal& m) {
    const long double norm = LengthOf(m);
    if (norm < shortest || norm > longest) return;
    const Errors errors = ErrorsOf(m);
    if (errors.*goal > worst.*goal) at = m;
    worst = {std::max(worst.component, errors.component),
             std::max(worst.direction, errors.direction), std::max(worst.length, errors.length)};
  };
  for (int i = 0; i < 400000; ++i) {
    attempt(NormalOf(shortest * std::pow(longest / shortest, uniform(random)), random));
  }
  for (int i = 0; i < 400000; ++i) {
    Normal m = at;
    for (Quantity& c : m) {
      c = Quantity::Wrap(c.raw() + (AnyOctave(28, random) >> (random() % 2 ? 30 : 0)));
    }
    attempt(m);
  }
  return worst;
}

TEST(PhongDirect, ModelWithinErrorBound) {
  const double longest = 1 + std::ldexp(1, -9);
  const Errors from_eighth = Search(0.125, longest, &Errors::component, 1);
  RecordProperty("worst_component_milliulp", static_cast<int>(from_eighth.component * 1000));
  EXPECT_LT(from_eighth.component, PhongDirect::kContract.max_error_ulp);
  EXPECT_GT(from_eighth.component, 1) << "the search is blind";

  Errors any = Search(kShortest, longest, &Errors::direction, 2);
  const Errors by_length = Search(kShortest, longest, &Errors::length, 3);
  any.direction = std::max(any.direction, by_length.direction);
  any.length = std::max(any.length, by_length.length);
  RecordProperty("worst_direction_millilog2", static_cast<int>(std::log2(any.direction) * 1000));
  RecordProperty("worst_length_millilog2", static_cast<int>(std::log2(any.length) * 1000));
  EXPECT_LT(any.direction, std::pow(2, -24));
  EXPECT_LT(any.length, std::pow(2, -22.7));
  EXPECT_GT(any.direction, std::pow(2, -24.6)) << "the search is blind";
}

TEST(PhongDirect, ZeroStaysZero) {
  EXPECT_EQ(PhongDirect::Of(Raw(0, 0, 0)), PixelNormal{});
  // 2^-23: its square is below 2^-44.
  EXPECT_EQ(PhongDirect::Of(Raw(kOne >> 23, 0, -(kOne >> 23))), PixelNormal{});
}

TEST(PhongDirect, AxesOfEveryLengthAreExact) {
  for (int shift = 0; shift <= 22; ++shift) {
    const PixelNormal n = PhongDirect::Of(Raw(0, -(kOne >> shift), 0));
    EXPECT_EQ(n[0].raw(), 0);
    EXPECT_EQ(n[1].raw(), -(1 << 24)) << shift;
    EXPECT_EQ(n[2].raw(), 0);
  }
}

TEST(PhongDirect, LengthSlightlyAboveOne) {
  const PixelNormal n = PhongDirect::Of(Raw(0, 0, kOne + (kOne >> 9)));
  EXPECT_NEAR(static_cast<double>(n[2].raw()), 1 << 24, 2);
}

TEST(PhongDirect, TooLongCountsAsTwo) {
  const PixelNormal n = PhongDirect::Of(Raw(2 * kOne - 1, -2 * kOne, kOne));
  EXPECT_NEAR(n[0].ToReal(), 1, 1e-6);
  EXPECT_NEAR(n[1].ToReal(), -1, 1e-6);
  EXPECT_NEAR(n[2].ToReal(), 0.5, 1e-6);
}

}  // namespace
}  // namespace shading
