// SPDX-License-Identifier: Apache-2.0
#include "model/light/dot_product.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/fixed/wide_integer.h"
#include "tb/dut/dot_product_dut.h"
#include "tests/unit/light/light_stimulus.h"

namespace shading {
namespace {

constexpr int kInputs = 300000;
using Dut = tb::DotProductDut;

// All bits, ends of the range, or small.
template <typename Fixed>
Fixed RandomComponent(std::mt19937& random) {
  const int64_t limit = int64_t{1} << (Fixed::kWidth - 1);
  switch (random() % 6) {
    case 0: return Fixed::FromRaw(random() % 2 ? limit - 1 : -limit);
    case 1: return Fixed::FromRaw(random() % 2 ? limit / 2 : -limit / 2);
    case 2: return Fixed::FromRaw(static_cast<int64_t>(random() % 5) - 2);
    default: return Fixed::Wrap(static_cast<int64_t>(random()));
  }
}

Dut::Input RandomInput(std::mt19937& random) {
  Dut::Input input;
  for (auto& component : input.normal) component = RandomComponent<PixelNormalComponent>(random);
  for (auto& component : input.vector) component = RandomComponent<NormalComponent>(random);
  return input;
}

// The sum in 2^-46, exact.
Int128 ExactSum(const Dut::Input& input) {
  Int128 sum = 0;
  for (size_t k = 0; k < 3; ++k) {
    sum += static_cast<Int128>(input.normal[k].raw()) * input.vector[k].raw();
  }
  return sum;
}

Cosine Model(const Dut::Input& input) { return DotProduct::Of(input.normal, input.vector); }

class DotProductFlow : public testing::TestWithParam<Flow> {};

TEST_P(DotProductFlow, RtlMatchesModel) {
  Dut dut;
  std::mt19937 random(1);
  ExpectSameStream(
      &dut, PatternOf(GetParam(), 2), kInputs, [&] { return RandomInput(random); }, Model);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, DotProductFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(DotProduct, ContractMatchesRtl) { ExpectTiming<Dut>(DotProduct::kContract, {}); }

TEST(DotProduct, ModelWithinErrorBound) {
  std::mt19937 random(3);
  int64_t worst = 0;  // 2^-46
  int saturated = 0;
  for (int i = 0; i < 1000000; ++i) {
    const Dut::Input input = RandomInput(random);
    const Int128 exact = ExactSum(input);
    const int64_t actual = Model(input).raw();
    constexpr Int128 kLimit = Int128{1} << 47;  // 2
    if (exact < -kLimit || exact >= kLimit - (1 << 15)) {
      ++saturated;
      ASSERT_EQ(actual, exact < 0 ? -2 * kOneCosine : 2 * kOneCosine - 1);
      continue;
    }
    const int64_t error = static_cast<int64_t>(static_cast<Int128>(actual) * 65536 - exact);
    worst = std::max(worst, std::abs(error));
  }
  EXPECT_LE(std::ldexp(static_cast<double>(worst), -16), DotProduct::kContract.max_error_ulp);
  EXPECT_GT(std::ldexp(static_cast<double>(worst), -16), 0.499) << "the search is blind";
  EXPECT_GT(saturated, 1000);
}

// Sum 2^-31 and its neighbours: a normal of 2^-9 times a vector of 2^-22.
TEST(DotProduct, HalvesGoUp) {
  const auto dot = [](int64_t normal) {
    Dut::Input input = {};
    input.normal[1] = PixelNormalComponent::FromRaw(normal);
    input.vector[1] = NormalComponent::FromRaw(1);
    return Model(input).raw();
  };
  EXPECT_EQ(dot(1 << 15), 1);
  EXPECT_EQ(dot((1 << 15) - 1), 0);
  EXPECT_EQ(dot(-(1 << 15)), 0);
  EXPECT_EQ(dot(-(1 << 15) - 1), -1);
}

TEST(DotProduct, UnitAxesAreExact) {
  Dut::Input input = {};
  input.normal[2] = PixelNormalComponent::FromRaw(1 << 24);
  input.vector[2] = NormalComponent::FromRaw(1 << 22);
  EXPECT_EQ(Model(input).raw(), kOneCosine);
  input.normal[2] = PixelNormalComponent::FromRaw(-(1 << 24));
  EXPECT_EQ(Model(input).raw(), -kOneCosine);
  input.vector = {};
  EXPECT_EQ(Model(input).raw(), 0);
}

}  // namespace
}  // namespace shading
