// SPDX-License-Identifier: Apache-2.0
#include "model/light/blinn_specular.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <sstream>
#include <string>

#include "model/light/specular_power.h"
#include "scripts/tables/specular_table.h"
#include "tb/dut/blinn_specular_dut.h"
#include "tests/unit/light/light_stimulus.h"

namespace shading {
namespace {

constexpr int kInputs = 600000;
using Dut = tb::BlinnSpecularDut;

int64_t Raw(int64_t x, int64_t n) {
  return BlinnSpecular(Shininess::FromRaw(n)).Of(Cosine::FromRaw(x)).raw();
}

Dut::Output Model(const Dut::Input& input) {
  const bool lit = !input.skip && BlinnSpecular::Lit(input.x);
  return {lit ? BlinnSpecular(input.n).Of(input.x) : Highlight(), !lit};
}

Dut::Input RandomInput(std::mt19937& random) {
  const Shininess any = Shininess::FromRaw(random() % (Shininess::kMaxRaw + 1));
  const Shininess n = random() % 16 == 0 ? any : RandomShininess(random);
  return {RandomCosine(random), n, random() % 8 == 0};
}

// The last cosines that are dark and the first that are not, and where octaves meet.
Dut::Input BorderInput(std::mt19937& random) {
  const Shininess n = RandomShininess(random);
  const int64_t edge =
      random() % 2 ? BlinnSpecular(n).least_visible().raw() : kOneCosine >> (random() % 31);
  return {Cosine::FromRaw(edge + static_cast<int64_t>(random() % 5) - 2), n, false};
}

class BlinnSpecularFlow : public testing::TestWithParam<Flow> {};

TEST_P(BlinnSpecularFlow, RtlMatchesModel) {
  Dut dut;
  std::mt19937 random(1);
  ExpectSameStream(
      &dut, PatternOf(GetParam(), 2), kInputs, [&] { return RandomInput(random); }, Model);
  ExpectSameStream(
      &dut, PatternOf(GetParam(), 2), 100000, [&] { return BorderInput(random); }, Model);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, BlinnSpecularFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(BlinnSpecular, ContractMatchesRtl) { ExpectTiming<Dut>(BlinnSpecular::kContract, {}); }

// Ulp of U1.16, against the power of the same x and n.
double Error(int64_t x, int64_t n) {
  const long double ideal = std::pow(std::ldexp(static_cast<long double>(x), -30),
                                     std::ldexp(static_cast<long double>(n), -7));
  return std::abs(static_cast<double>(Raw(x, n) - std::ldexp(ideal, 16)));
}

struct Worst {
  double error = 0;
  int64_t x = 0, n = 0;

  void Try(int64_t new_x, int64_t new_n) {
    const int64_t clamped_x = std::clamp<int64_t>(new_x, 0, kOneCosine);
    const int64_t clamped_n = std::clamp(new_n, kLeastShininess, kMostShininess);
    const double new_error = Error(clamped_x, clamped_n);
    if (new_error > error) *this = {new_error, clamped_x, clamped_n};
  }
};

TEST(BlinnSpecular, ModelWithinErrorBound) {
  std::mt19937 random(1);
  Worst worst;
  for (int64_t x = kOneCosine - 50000; x <= kOneCosine; ++x) worst.Try(x, kMostShininess);
  for (int i = 0; i < 500000; ++i) {
    worst.Try(RandomPositive(random), RandomShininess(random).raw());
    worst.Try(RandomPositive(random), kMostShininess - random() % 64);
  }
  // Hill climbing: steps of every size around the worst case so far.
  for (int i = 0; i < 500000; ++i) {
    const int64_t dx = static_cast<int64_t>(random() % (1 << 22)) >> (random() % 22);
    const int64_t dn = static_cast<int64_t>(random() % 64) >> (random() % 8);
    worst.Try(worst.x + (random() % 2 ? dx : -dx), worst.n + (random() % 2 ? dn : -dn));
  }
  RecordProperty("worst_error_milliulp", static_cast<int>(worst.error * 1000));
  EXPECT_LT(worst.error, BlinnSpecular::kContract.max_error_ulp) << worst.x << ' ' << worst.n;
  EXPECT_GT(worst.error, 0.52) << "the search is blind";
}

// The front end's power, 0.82 ulp of U1.30, computes it by shifts and additions.
TEST(BlinnSpecular, AgreesWithTheShiftAddPower) {
  std::mt19937 random(2);
  for (int i = 0; i < 300000; ++i) {
    const Dut::Input input = {RandomCosine(random), RandomShininess(random)};
    const double fine =
        std::ldexp(static_cast<double>(SpecularPower::Of(input.x, input.n).raw()), 16 - 30);
    ASSERT_LT(std::abs(static_cast<double>(BlinnSpecular(input.n).Of(input.x).raw()) - fine),
              BlinnSpecular::kContract.max_error_ulp + std::ldexp(1, -14));
  }
}

template <typename Write>
void ExpectFileIs(const char* path, Write write) {
  std::ifstream file(std::string(SHADESIM_ROOT) + "/" + path);
  const std::string committed{std::istreambuf_iterator<char>(file), {}};
  std::ostringstream written;
  write(written);
  EXPECT_TRUE(committed == written.str()) << path << " is not what specular_table writes";
}

TEST(BlinnSpecular, TablesAreTheClosedForms) {
  ExpectFileIs(tables::kModelFile, tables::WriteModel);
  ExpectFileIs(tables::kRtlFile, tables::WriteRtl);
  const auto expect_same = [](const auto& table, const std::vector<tables::Segment>& fit) {
    ASSERT_EQ(table.size(), fit.size());
    for (size_t k = 0; k < fit.size(); ++k) {
      EXPECT_EQ(table[k].value, fit[k].value) << k;
      EXPECT_EQ(table[k].slope, fit[k].slope) << k;
      EXPECT_EQ(table[k].curvature, fit[k].curvature) << k;
    }
  };
  expect_same(kLogTable, tables::LogTable());
  expect_same(kExpTable, tables::ExpTable());
}

// Inside a segment no truncation can lower the curve; these are the borders, all of them. With
// them the order holds for every x and n.
TEST(BlinnSpecular, SegmentsMeetInOrder) {
  for (int64_t x = kOneCosine; x > 1; x /= 2) {
    EXPECT_EQ(BlinnSpecular::NegativeLog2(x) % (int64_t{1} << 30), 0) << "powers of two are exact";
    for (int64_t k = 1; k <= 128; ++k) {
      const int64_t border = x - (k * x) / 256;  // u = k / 128
      if (border < 2) continue;
      EXPECT_LE(BlinnSpecular::NegativeLog2(border + 1), BlinnSpecular::NegativeLog2(border));
      EXPECT_LE(BlinnSpecular::NegativeLog2(border), BlinnSpecular::NegativeLog2(border - 1));
    }
  }
  EXPECT_EQ(BlinnSpecular::Exp2(0), 1 << 22);
  for (int64_t k = 1; k < 32; ++k) {
    EXPECT_LE(BlinnSpecular::Exp2((k << 18) - 1), BlinnSpecular::Exp2(k << 18)) << k;
  }
  EXPECT_LE(BlinnSpecular::Exp2((1 << 23) - 1), 1 << 23);
}

TEST(BlinnSpecular, RisesWithCosineAndFallsWithShininess) {
  std::mt19937 random(3);
  for (const int64_t n : {kLeastShininess, kLeastShininess + 1, 8 * kLeastShininess,
                          kMostShininess - 1, kMostShininess}) {
    const BlinnSpecular power(Shininess::FromRaw(n));
    for (int i = 0; i < 300000; ++i) {
      const Cosine x = Cosine::FromRaw(std::max<int64_t>(RandomPositive(random), 1));
      ASSERT_LE(power.Of(Cosine::FromRaw(x.raw() - 1)).raw(), power.Of(x).raw()) << x.raw();
    }
  }
  for (int i = 0; i < 4; ++i) {
    const int64_t x = RandomPositive(random);
    for (int64_t n = kLeastShininess; n < kMostShininess; ++n) {
      ASSERT_GE(Raw(x, n), Raw(x, n + 1)) << x << ' ' << n;
    }
  }
}

TEST(BlinnSpecular, ZeroOneAndPowersOfTwoAreExact) {
  for (const int64_t n : {kLeastShininess, kLeastShininess + 1, kMostShininess}) {
    EXPECT_EQ(Raw(0, n), 0);
    EXPECT_EQ(Raw(-1, n), 0);
    EXPECT_EQ(Raw(-2 * kOneCosine, n), 0);
    EXPECT_EQ(Raw(kOneCosine, n), 1 << 16);
    EXPECT_EQ(Raw(kOneCosine + 1, n), 1 << 16) << "clamped before the power";
    EXPECT_EQ(Raw(2 * kOneCosine - 1, n), 1 << 16);
  }
  for (int64_t n = 1; n <= 16; ++n) {
    EXPECT_EQ(Raw(kOneCosine / 2, n * kLeastShininess), 65536 >> n);
  }
  EXPECT_EQ(Raw(kOneCosine / 4, kLeastShininess + kLeastShininess / 2), 65536 / 8);
}

TEST(BlinnSpecular, UnderflowsToZero) {
  EXPECT_EQ(Raw(kOneCosine / 2, 17 * kLeastShininess), 1) << "half an ulp rounds up";
  EXPECT_EQ(Raw(kOneCosine / 2, 17 * kLeastShininess + 1), 0);
  EXPECT_EQ(Raw(1, kLeastShininess), 0);
  EXPECT_EQ(Raw(1, kMostShininess), 0);
  EXPECT_EQ(Raw(1, Shininess::kMaxRaw), 0);
  EXPECT_EQ(Raw(1, 0), 1 << 16) << "x^0";
}

TEST(BlinnSpecular, LeastVisibleIsTheBorder) {
  for (int64_t n = kLeastShininess; n <= kMostShininess; n += 37) {
    const BlinnSpecular power(Shininess::FromRaw(n));
    const int64_t least = power.least_visible().raw();
    EXPECT_NE(power.Of(Cosine::FromRaw(least)).raw(), 0);
    EXPECT_LT(std::pow(std::ldexp(static_cast<double>(least - 1), -30),
                       std::ldexp(static_cast<double>(n), -7)),
              0.66 / 65536);
  }
}

}  // namespace
}  // namespace shading
