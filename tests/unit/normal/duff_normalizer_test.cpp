// SPDX-License-Identifier: Apache-2.0
#include "model/normal/duff_normalizer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tb/dut/duff_normalizer_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {
namespace {

using Dut = tb::DuffNormalizerDut;
using Input = tb::DuffInput;

constexpr int64_t kOne = int64_t{1} << Quantity::kFraction;
constexpr int64_t kOneSquare = int64_t{1} << LengthSquare::kFraction;
constexpr int64_t kOneCosine = int64_t{1} << Cosine::kFraction;

LightCosines Of(const Input& in) { return DuffNormalizer::Of(in.n_dot_l, in.n_dot_h_or_v, in.q); }

int64_t Raw(int64_t dot, int64_t q) {
  return Of({Quantity::FromRaw(dot), Quantity{}, LengthSquare::FromRaw(q)}).n_dot_l.raw();
}

bool Same(const LightCosines& a, const LightCosines& b) {
  return a.n_dot_l == b.n_dot_l && a.n_dot_h_or_v == b.n_dot_h_or_v;
}

// Dot products that belong to q, up to a little beyond its root; or unrelated numbers.
Input AnyInput(std::mt19937& random) {
  if (random() % 4 == 0) {
    return {AnyQuantity(random), AnyQuantity(random),
            LengthSquare::Wrap(AnyOctave(LengthSquare::kWidth, random))};
  }
  std::uniform_real_distribution<double> cosine(-1.002, 1.002);
  const double length = RandomLength(std::ldexp(1, -9), random);
  const auto pick = [&] { return random() % 4 ? cosine(random) : random() % 2 ? 1 : -1; };
  return {Quantity::Round(length * pick()), Quantity::Round(length * pick()),
          LengthSquare::Wrap(LengthSquare::Round(length * length).raw() +
                             static_cast<int64_t>(random() % 3) - 1)};
}

class DuffNormalizerFlow : public testing::TestWithParam<Flow> {};

TEST_P(DuffNormalizerFlow, RtlMatchesModel) {
  std::mt19937 random(1);
  ExpectSameStream<Dut>(
      PatternOf(GetParam(), 2), 500000, [&] { return AnyInput(random); }, Of, Same);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, DuffNormalizerFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(DuffNormalizer, ContractMatchesRtl) {
  ExpectPipelineTiming<Dut>(DuffNormalizer::kContract, Input{Quantity::FromRaw(kOne), Quantity{},
                                                             LengthSquare::FromRaw(kOneSquare)});
}

// In ulp of S1.30.
double Error(int64_t dot, int64_t q) {
  const long double ideal = std::ldexp(static_cast<long double>(dot), 22 - 38 + 30) /
                            std::sqrt(static_cast<long double>(q));
  return static_cast<double>(std::abs(static_cast<long double>(Raw(dot, q)) - ideal));
}

TEST(DuffNormalizer, ModelWithinErrorBound) {
  std::mt19937 random(1);
  struct {
    double error;
    int64_t dot, q;
  } worst = {0, kOne, kOneSquare};
  const auto attempt = [&](int64_t dot, int64_t q) {
    if (q <= 0 || q >= 2 * kOneSquare) return;
    const auto most =
        static_cast<int64_t>(std::ldexp(std::sqrt(static_cast<long double>(q)), 38 - 22));
    const int64_t within = std::clamp(dot, -most, most);
    const double error = Error(within, q);
    if (error > worst.error) worst = {error, within, q};
  };
  // Both ends of every segment of the reciprocal square root, in every octave; then between.
  for (int shift = 0; shift < 22; ++shift) {
    for (int64_t k = 0; k < 3 * 128; ++k) {
      for (int64_t near = -2; near <= 2; ++near) {
        const int64_t q = ((kOneSquare + (k << 37)) >> (2 * shift)) + near;
        attempt(2 * kOne - 1, q);
        attempt(-2 * kOne, q);
      }
    }
  }
  for (int i = 0; i < 2000000; ++i) {
    const int64_t q = kOneSquare / 2 + (Bits64(random) & (kOneSquare - 1));
    attempt(random() % 2 ? 2 * kOne - 1 : -2 * kOne, random() % 2 ? q : q >> (random() % 18));
  }
  for (int i = 0; i < 1000000; ++i) {
    attempt(worst.dot + AnyOctave(30, random), worst.q + AnyOctave(36, random));
  }
  RecordProperty("worst_error_milliulp", static_cast<int>(worst.error * 1000));
  EXPECT_LT(worst.error, DuffNormalizer::kContract.max_error_ulp);
  EXPECT_GT(worst.error, 60) << "the search is blind";
}

// An error of q acts as the contract says: dq / (2 q) of the cosine.
TEST(DuffNormalizer, ErrorOfTheSquareActsByHalf) {
  std::mt19937 random(2);
  for (int i = 0; i < 200000; ++i) {
    const int64_t q = (kOneSquare >> 6) + (Bits64(random) & (kOneSquare / 2 - 1));
    const int64_t dq = q >> 14;
    const auto dot =
        static_cast<int64_t>(std::ldexp(std::sqrt(static_cast<long double>(q)), 38 - 22));
    const double change = static_cast<double>(Raw(dot, q) - Raw(dot, q + dq)) / kOneCosine;
    ASSERT_NEAR(change, std::ldexp(1, -15), std::ldexp(1, -22));
  }
}

TEST(DuffNormalizer, NoLengthGivesNoLight) {
  for (const int64_t q : {int64_t{0}, int64_t{-1}, -kOneSquare, -2 * kOneSquare}) {
    EXPECT_EQ(Raw(kOne, q), 0);
    EXPECT_EQ(Raw(-kOne, q), 0);
  }
}

TEST(DuffNormalizer, PowersOfFourAreExact) {
  for (int e = 0; e <= 22; ++e) {
    EXPECT_EQ(Raw(kOne >> e, kOneSquare >> (2 * e)), kOneCosine);
    EXPECT_EQ(Raw(-(kOne >> e), kOneSquare >> (2 * e)), -kOneCosine);
  }
}

TEST(DuffNormalizer, SaturatesCosinesBeyondTheRange) {
  EXPECT_EQ(Raw(kOne, 1), 2 * kOneCosine - 1);
  EXPECT_EQ(Raw(-kOne, 1), -2 * kOneCosine);
  EXPECT_EQ(Raw(2 * kOne - 1, kOneSquare >> 1), 2 * kOneCosine - 1);
  EXPECT_EQ(Raw(-2 * kOne, kOneSquare), -2 * kOneCosine);
}

TEST(DuffNormalizer, LengthSlightlyAboveOne) {
  const int64_t dot = kOne + (kOne >> 9);
  const int64_t q = kOneSquare + (kOneSquare >> 8) + (kOneSquare >> 18);
  EXPECT_NEAR(static_cast<double>(Raw(dot, q)), kOneCosine, 88);
}

TEST(DuffNormalizer, BothCosinesHaveTheSameScale) {
  std::mt19937 random(3);
  for (int i = 0; i < 100000; ++i) {
    Input in = AnyInput(random);
    in.n_dot_h_or_v = in.n_dot_l;
    const LightCosines cosines = Of(in);
    ASSERT_EQ(cosines.n_dot_l, cosines.n_dot_h_or_v);
  }
}

}  // namespace
}  // namespace shading
