// SPDX-License-Identifier: Apache-2.0
#include "model/light/rgb_combine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tb/dut/rgb_combine_dut.h"
#include "tests/unit/light/light_stimulus.h"

namespace shading {
namespace {

constexpr int kInputs = 300000;
using Dut = tb::RgbCombineDut;

PixelCodes Model(const Dut::Input& input) {
  return RgbCombine::Of(input.diffuse, input.highlight, input.material);
}

Dut::Input RandomInput(std::mt19937& random, bool any = true) {
  constexpr int64_t kOne = int64_t{1} << Diffuse::kFraction;
  Dut::Input input;
  const int64_t factor = any ? Diffuse::kMaxRaw + 1 : kOne + 1;
  input.diffuse = Diffuse::FromRaw(random() % 4 ? random() % factor : random() % 2 * kOne);
  input.highlight = Highlight::FromRaw(RandomReflectance(random, any).raw());
  input.material = RandomMaterial(random, any);
  return input;
}

class RgbCombineFlow : public testing::TestWithParam<Flow> {};

TEST_P(RgbCombineFlow, RtlMatchesModel) {
  Dut dut;
  std::mt19937 random(1);
  ExpectSameStream(
      &dut, PatternOf(GetParam(), 2), kInputs, [&] { return RandomInput(random); }, Model);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, RgbCombineFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(RgbCombine, ContractMatchesRtl) { ExpectTiming<Dut>(RgbCombine::kContract, {}); }

// Sums of 36 bits and their 255-fold are exact in double.
TEST(RgbCombine, ModelWithinErrorBound) {
  std::mt19937 random(3);
  double worst = 0;
  for (int i = 0; i < 1000000; ++i) {
    const Dut::Input input = RandomInput(random, i % 2 == 0);
    const Material& m = input.material;
    const PixelCodes codes = Model(input);
    const std::array<int, 3> actual = {codes.r, codes.g, codes.b};
    for (size_t c = 0; c < 3; ++c) {
      const double ideal = m.ambient[c].ToReal() + m.diffuse[c].ToReal() * input.diffuse.ToReal() +
                           m.specular[c].ToReal() * input.highlight.ToReal();
      worst = std::max(worst, std::abs(actual[c] - 255 * std::min(ideal, 1.0)));
    }
  }
  EXPECT_LE(worst, RgbCombine::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.4999) << "the search is blind";
}

Rgb Grey(int64_t raw) {
  const Reflectance r = Reflectance::FromRaw(raw);
  return {r, r, r};
}

TEST(RgbCombine, EndsAreExactAndClamp) {
  const Diffuse full_diffuse = Diffuse::FromRaw(1 << 17);
  const Highlight full_highlight = Highlight::FromRaw(1 << 16);
  const PixelCodes black = {0, 0, 0}, white = {255, 255, 255};
  EXPECT_EQ(RgbCombine::Of(full_diffuse, full_highlight, {}), black);
  EXPECT_EQ(RgbCombine::Of({}, {}, {Grey(0), Grey(65536), Grey(65536), {}}), black);
  EXPECT_EQ(RgbCombine::Of({}, {}, {Grey(65536), Grey(0), Grey(0), {}}), white);
  EXPECT_EQ(RgbCombine::Of(full_diffuse, {}, {Grey(0), Grey(65536), Grey(0), {}}), white);
  EXPECT_EQ(RgbCombine::Of({}, full_highlight, {Grey(0), Grey(0), Grey(65536), {}}), white);
  EXPECT_EQ(
      RgbCombine::Of(full_diffuse, full_highlight, {Grey(131071), Grey(131071), Grey(131071), {}}),
      white);
}

// 32896 / 65536 is 128 codes and 257/65536 one code: 255 I of 65536 / 2 is 127.5.
TEST(RgbCombine, HalfACodeRoundsUp) {
  EXPECT_EQ(RgbCombine::Of({}, {}, {Grey(32768), Grey(0), Grey(0), {}}).r, 128);
  EXPECT_EQ(RgbCombine::Of({}, {}, {Grey(32767), Grey(0), Grey(0), {}}).r, 127);
}

TEST(RgbCombine, ChannelsAreApart) {
  Material material;
  material.ambient[0] = Reflectance::FromRaw(65536);
  material.diffuse[1] = Reflectance::FromRaw(65536);
  material.specular[2] = Reflectance::FromRaw(65536);
  const PixelCodes expected = {255, 128, 64};
  EXPECT_EQ(RgbCombine::Of(Diffuse::FromRaw(1 << 16), Highlight::FromRaw(1 << 14), material),
            expected);
}

}  // namespace
}  // namespace shading
