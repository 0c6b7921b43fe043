// SPDX-License-Identifier: Apache-2.0
#include "model/light/specular_power.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace shading {
namespace {

constexpr int64_t kOne = int64_t{1} << Cosine::kFraction;
constexpr int64_t kLeastN = int64_t{1} << Shininess::kFraction;  // 1
constexpr int64_t kMostN = kLeastN << 8;                         // 256

int64_t Raw(int64_t x, int64_t n) {
  return SpecularPower::Of(Cosine::FromRaw(x), Shininess::FromRaw(n)).raw();
}

// In ulp of U1.30, against the power of the same x and n.
double Error(int64_t x, int64_t n) {
  const long double ideal = std::pow(std::ldexp(static_cast<long double>(x), -Cosine::kFraction),
                                     std::ldexp(static_cast<long double>(n), -7));
  const long double actual = static_cast<long double>(Raw(x, n));
  return std::abs(static_cast<double>(actual - std::ldexp(ideal, SpecularFactor::kFraction)));
}

struct Worst {
  double error = 0;
  int64_t x = 0, n = 0;

  void Try(int64_t new_x, int64_t new_n) {
    const int64_t clamped_x = std::clamp<int64_t>(new_x, 0, kOne);
    const int64_t clamped_n = std::clamp(new_n, kLeastN, kMostN);
    const double new_error = Error(clamped_x, clamped_n);
    if (new_error > error) *this = {new_error, clamped_x, clamped_n};
  }
};

// A cosine whose power is visible: 1 - x down to 2^-30, equally likely in every octave.
int64_t RandomCosine(std::mt19937& random) {
  const int64_t gap = static_cast<int64_t>(random() & (kOne - 1)) >> (random() % 30);
  return random() % 8 == 0 ? gap : kOne - gap;
}

TEST(SpecularPower, ModelWithinErrorBound) {
  std::mt19937 random(1);
  Worst worst;
  for (int64_t x = kOne - 50000; x <= kOne; ++x) {
    for (const int64_t n : {kLeastN, kMostN - 1, kMostN}) worst.Try(x, n);
  }
  for (int i = 0; i < 500000; ++i) {
    worst.Try(RandomCosine(random), kLeastN + random() % (kMostN - kLeastN + 1));
    worst.Try(RandomCosine(random), kMostN - random() % 4);
  }
  // Hill climbing: steps of every size around the worst case so far.
  for (int i = 0; i < 200000; ++i) {
    const int64_t dx = static_cast<int64_t>(random() % 65536) >> (random() % 16);
    const int64_t dn = static_cast<int64_t>(random() % 64) >> (random() % 8);
    worst.Try(worst.x + (random() % 2 ? dx : -dx), worst.n + (random() % 2 ? dn : -dn));
  }
  RecordProperty("worst_error_milliulp", static_cast<int>(worst.error * 1000));
  EXPECT_LT(worst.error, SpecularPower::kContract.max_error_ulp)
      << "x " << worst.x << " n " << worst.n;
  EXPECT_GT(worst.error, 0.5) << "the search is blind: rounding alone costs half an ulp";
}

TEST(SpecularPower, TableIsLog2OfTheFactors) {
  for (int k = 1; k <= SpecularPower::kSteps; ++k) {
    const long double log2 = std::log1p(std::ldexp(1.0L, -k)) / std::log(2.0L);
    EXPECT_EQ(SpecularPower::kLog2[static_cast<size_t>(k - 1)],
              std::llround(std::ldexp(log2, SpecularPower::kFraction)))
        << "k " << k;
  }
}

TEST(SpecularPower, ZeroOneAndPowersOfTwoAreExact) {
  for (const int64_t n : {kLeastN, kLeastN + 1, kMostN - 1, kMostN}) {
    EXPECT_EQ(Raw(0, n), 0);
    EXPECT_EQ(Raw(kOne, n), kOne);
  }
  for (int64_t n = 1; n <= 30; ++n) EXPECT_EQ(Raw(kOne / 2, n * kLeastN), kOne >> n);
  EXPECT_EQ(Raw(kOne / 4, kLeastN + kLeastN / 2), kOne / 8);
}

TEST(SpecularPower, ClampsTheCosine) {
  EXPECT_EQ(Raw(-1, kLeastN), 0);
  EXPECT_EQ(Raw(-2 * kOne, kMostN), 0);
  EXPECT_EQ(Raw(kOne + 1, kMostN), kOne);
  EXPECT_EQ(Raw(2 * kOne - 1, kMostN), kOne);
}

TEST(SpecularPower, UnderflowsToZero) {
  EXPECT_EQ(Raw(1, kMostN), 0);
  EXPECT_EQ(Raw(1, kLeastN), 1);
  EXPECT_EQ(Raw(kOne / 2, 31 * kLeastN), 1) << "half an ulp rounds up";
  EXPECT_EQ(Raw(kOne / 2, 31 * kLeastN + 1), 0);
  EXPECT_EQ(Raw(kOne / 2, 32 * kLeastN), 0);
}

TEST(SpecularPower, RisesWithCosine) {
  std::mt19937 random(2);
  for (const int64_t n : {kLeastN, kLeastN + 1, 8 * kLeastN, kMostN}) {
    for (int i = 0; i < 50000; ++i) {
      const int64_t x = std::max<int64_t>(RandomCosine(random), 1);
      ASSERT_LE(Raw(x - 1, n), Raw(x, n)) << "x " << x << " n " << n;
    }
  }
  for (int64_t x = 1; x < 50000; ++x) ASSERT_LE(Raw(x - 1, kLeastN), Raw(x, kLeastN));
}

TEST(SpecularPower, FallsWithShininess) {
  std::mt19937 random(3);
  for (int i = 0; i < 20; ++i) {
    const int64_t x = RandomCosine(random);
    for (int64_t n = kLeastN; n < kMostN; ++n) ASSERT_GE(Raw(x, n), Raw(x, n + 1)) << x << ' ' << n;
  }
  for (int64_t n = kLeastN; n < kMostN; ++n) ASSERT_GE(Raw(kOne - 1, n), Raw(kOne - 1, n + 1));
}

TEST(SpecularPower, AcceptsAnyShininess) {
  EXPECT_EQ(Raw(1, 0), kOne) << "x^0";
  EXPECT_EQ(Raw(0, 0), 0);
  std::mt19937 random(4);
  for (int i = 0; i < 100000; ++i) {
    const int64_t n = random() % (Shininess::kMaxRaw + 1);
    ASSERT_LT(Error(1 + RandomCosine(random) % kOne, n), 1 + static_cast<double>(n) / kMostN);
  }
}

}  // namespace
}  // namespace shading
