// SPDX-License-Identifier: Apache-2.0
#include "model/normal/reciprocal_sqrt.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tb/dut/reciprocal_sqrt_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/pipeline_flow.h"

namespace shading {
namespace {

using Dut = tb::ReciprocalSqrtDut;

constexpr int64_t kOne = int64_t{1} << SquaredLength::kFraction;
constexpr int kSegments = 256;
constexpr double kUlp = 1 << 24;

ReciprocalRoot Of(int64_t q) { return ReciprocalSqrt::Of(SquaredLength::FromRaw(q)); }

bool Same(const ReciprocalRoot& a, const ReciprocalRoot& b) {
  return a.mantissa == b.mantissa && a.exponent == b.exponent;
}

// First x of a segment, U2.44, and what one step of t is worth.
int64_t StartOf(int k) {
  return k < kSegments / 2 ? kOne + (int64_t{k} << 37) : 2 * kOne + (int64_t{k - 128} << 38);
}
int64_t StepOf(int k) { return int64_t{1} << (k < kSegments / 2 ? 17 : 18); }

// Around a border of a segment or of an octave, moved down by an even number of bits; or anything.
SquaredLength AnySquare(std::mt19937& random) {
  const int64_t near = static_cast<int64_t>(random() % 5) - 2;
  const int shift = static_cast<int>(random() % 23) * 2;
  switch (random() % 4) {
    case 0:
      return SquaredLength::Saturate((StartOf(static_cast<int>(random() % kSegments)) >> shift) +
                                     near);
    case 1: return SquaredLength::Saturate((int64_t{1} << (random() % 46)) + near);
    case 2: return SquaredLength::Saturate((kOne + (Bits64(random) & (3 * kOne - 1))) >> shift);
    default:
      return SquaredLength::FromRaw(
          static_cast<int64_t>(static_cast<uint64_t>(Bits64(random)) >> (18 + random() % 46)));
  }
}

class ReciprocalSqrtFlow : public testing::TestWithParam<Flow> {};

TEST_P(ReciprocalSqrtFlow, RtlMatchesModel) {
  std::mt19937 random(1);
  ExpectSameStream<Dut>(
      PatternOf(GetParam(), 2), 1000000, [&] { return AnySquare(random); }, ReciprocalSqrt::Of,
      Same);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, ReciprocalSqrtFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(ReciprocalSqrt, ContractMatchesRtl) {
  ExpectPipelineTiming<Dut>(ReciprocalSqrt::kContract, SquaredLength::FromRaw(kOne));
}

// Quadratic through the closed form at the Chebyshev nodes of each segment.
TEST(ReciprocalSqrt, TableIsTheInterpolant) {
  const long double root3 = std::sqrt(3.0L);
  const long double node[3] = {0.5L - root3 / 4, 0.5L, 0.5L + root3 / 4};
  const auto round = [](long double c) { return std::llround(std::ldexp(c, 28)); };
  for (int k = 0; k < kSegments; ++k) {
    long double f[3];
    for (int i = 0; i < 3; ++i) {
      const long double x = std::ldexp(static_cast<long double>(StartOf(k)), -44) +
                            std::ldexp(node[i], k < kSegments / 2 ? -7 : -6);
      f[i] = 1 / std::sqrt(x);
    }
    const long double d01 = (f[1] - f[0]) / (node[1] - node[0]);
    const long double d12 = (f[2] - f[1]) / (node[2] - node[1]);
    const long double curvature = (d12 - d01) / (node[2] - node[0]);
    const long double slope = curvature * (node[0] + node[1]) - d01;
    const long double value = f[0] - d01 * node[0] + curvature * node[0] * node[1];
    const uint64_t word = kReciprocalSqrtTable[static_cast<size_t>(k)];
    EXPECT_EQ(static_cast<int64_t>(word >> 34), round(value)) << "segment " << k;
    EXPECT_EQ(static_cast<int64_t>(word >> 13 & 0x1fffff), round(slope)) << "segment " << k;
    EXPECT_EQ(static_cast<int64_t>(word & 0x1fff), round(curvature)) << "segment " << k;
  }
}

// Every value that the unit can give: all t of all segments, at both ends of what t stands for.
// 1/sqrt falls, so the error inside lies between those at the ends.
TEST(ReciprocalSqrt, ModelWithinErrorBound) {
  double worst = 0;
  for (int k = 0; k < kSegments; ++k) {
    const int64_t start = StartOf(k), step = StepOf(k);
    const auto ideal = [&](int64_t t) {
      return kUlp / std::sqrt(std::ldexp(static_cast<double>(start + t * step), -44));
    };
    double low = 0, high = 0, at = ideal(0);
    for (int64_t t = 0; t < int64_t{1} << 20; ++t) {
      const double next = ideal(t + 1);
      const auto actual = static_cast<double>(Of(start + t * step).mantissa.raw());
      low = std::min(low, actual - at);
      high = std::max(high, actual - next);
      at = next;
    }
    worst = std::max({worst, -low, high});
    ASSERT_LT(worst, ReciprocalSqrt::kContract.max_error_ulp) << "segment " << k;
  }
  RecordProperty("worst_error_milliulp", static_cast<int>(worst * 1000));
  EXPECT_GT(worst, 0.5) << "the search is blind: rounding alone costs half an ulp";
}

TEST(ReciprocalSqrt, ExponentNormalisesEverySquare) {
  std::mt19937 random(3);
  for (int i = 0; i < 3000000; ++i) {
    const int64_t q = AnySquare(random).raw();
    if (q == 0) continue;
    const ReciprocalRoot root = Of(q);
    ASSERT_GE(q << (2 * root.exponent), kOne) << q;
    ASSERT_LT(q << (2 * root.exponent), 4 * kOne) << q;
    ASSERT_EQ(root.mantissa, Of(q << (2 * root.exponent)).mantissa) << q;
    const long double ideal = 1 / std::sqrt(std::ldexp(static_cast<long double>(q), -44));
    const long double error =
        static_cast<long double>(root.mantissa.raw()) - std::ldexp(ideal, 24 - root.exponent);
    ASSERT_LT(std::abs(error), ReciprocalSqrt::kContract.max_error_ulp) << q;
  }
}

TEST(ReciprocalSqrt, PowersOfFourAreExact) {
  for (int e = 0; e <= 22; ++e) {
    const ReciprocalRoot root = Of(kOne >> (2 * e));
    EXPECT_EQ(root.mantissa.raw(), 1 << 24);
    EXPECT_EQ(root.exponent, e);
    if (e == 0) continue;
    EXPECT_EQ(Of((kOne >> (2 * e)) * 4 - 1).exponent, e) << "just below the next";
  }
}

TEST(ReciprocalSqrt, ZeroGivesZero) {
  EXPECT_EQ(Of(0).mantissa.raw(), 0);
  EXPECT_EQ(Of(0).exponent, ReciprocalSqrt::kZeroExponent);
}

TEST(ReciprocalSqrt, ExtremesOfTheRange) {
  EXPECT_EQ(Of(1).mantissa.raw(), 1 << 24);
  EXPECT_EQ(Of(1).exponent, 22);
  EXPECT_EQ(Of(SquaredLength::kMaxRaw).mantissa.raw(), 1 << 23) << "1/2, just below 4";
  EXPECT_EQ(Of(SquaredLength::kMaxRaw).exponent, 0);
}

// Where segments meet the mantissa may rise, by one ulp: two errors below an ulp.
TEST(ReciprocalSqrt, RisesByAtMostAnUlpAcrossSegments) {
  for (int k = 0; k < kSegments; ++k) {
    for (int64_t t = k ? -64 : 0; t < 64; ++t) {
      const int64_t x = StartOf(k) + t * StepOf(k);
      ASSERT_LE(Of(x + StepOf(k)).mantissa.raw(), Of(x).mantissa.raw() + 1)
          << "segment " << k << " t " << t;
    }
  }
}

}  // namespace
}  // namespace shading
