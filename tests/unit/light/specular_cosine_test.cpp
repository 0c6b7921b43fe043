// SPDX-License-Identifier: Apache-2.0
#include "model/light/specular_cosine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>

#include "tb/dut/specular_cosine_dut.h"
#include "tests/unit/light/light_stimulus.h"
#include "tests/unit/light/normal_stimulus.h"

namespace shading {
namespace {

constexpr int kInputs = 300000;
using Dut = tb::SpecularCosineDut;

LightState RandomLight(Lighting lighting, std::mt19937& random) {
  return {lighting, RandomNormal(random), RandomNormal(random), RandomCosine(random)};
}

Dut::Output Model(const LightState& light, const LightCosines& cosines) {
  return {SpecularCosine::DiffuseOf(cosines), SpecularCosine::Unlit(cosines),
          SpecularCosine(light).Specular(cosines)};
}

class SpecularCosineFlow : public testing::TestWithParam<std::tuple<Lighting, Flow>> {};

TEST_P(SpecularCosineFlow, RtlMatchesModel) {
  const auto [lighting, flow] = GetParam();
  Dut dut;
  std::mt19937 random(1);
  for (int frame = 0; frame < 20; ++frame) {
    const LightState light = RandomLight(lighting, random);
    dut.SetLight(light);
    dut.Reset();
    ExpectSameStream(
        &dut, PatternOf(flow, 2), kInputs / 20, [&] { return RandomCosines(random); },
        [&](const LightCosines& cosines) { return Model(light, cosines); });
  }
}

INSTANTIATE_TEST_SUITE_P(AllFlows, SpecularCosineFlow,
                         testing::Combine(testing::Values(Lighting::kBlinn, Lighting::kPhong),
                                          testing::Values(Flow::kAlways, Flow::kOneInFour,
                                                          Flow::kRandom)),
                         [](const auto& test) {
                           return testing::PrintToString(std::get<0>(test.param)) +
                                  NameOf(std::get<1>(test.param));
                         });

TEST(SpecularCosine, ContractMatchesRtl) { ExpectTiming<Dut>(SpecularCosine::kContract, {}); }

// 64-bit mantissas: the closed form of Phong is exact before it is rounded to one.
TEST(SpecularCosine, ModelWithinErrorBound) {
  std::mt19937 random(3);
  long double worst_phong = 0, worst_diffuse = 0;
  for (int i = 0; i < 1000000; ++i) {
    const LightState light = RandomLight(Lighting::kPhong, random);
    const LightCosines cosines = RandomCosines(random);
    const auto real = [](Cosine c) { return static_cast<long double>(c.raw()) / kOneCosine; };
    const long double l = real(cosines.n_dot_l), v = real(cosines.n_dot_h_or_v);
    const long double ideal = 2 * l * v - real(light.l_dot_v);
    const Dut::Output out = Model(light, cosines);
    const long double clamped = std::clamp(ideal, -2.0L, 2.0L - 1.0L / kOneCosine);
    worst_phong = std::max(worst_phong, std::abs(out.specular.raw() - std::ldexp(clamped, 30)));
    worst_diffuse = std::max(
        worst_diffuse, std::abs(out.diffuse.raw() - std::ldexp(std::clamp(l, 0.0L, 1.0L), 17)));
    ASSERT_EQ(out.unlit, l <= 0);
  }
  EXPECT_LE(worst_phong, SpecularCosine::kContract.max_error_ulp);
  EXPECT_LE(worst_diffuse, SpecularCosine::kContract.max_error_ulp);
  EXPECT_GT(worst_phong, 0.4999L) << "the search is blind";
  EXPECT_GT(worst_diffuse, 0.4999L) << "the search is blind";
}

TEST(SpecularCosine, BlinnPassesTheCosineOn) {
  std::mt19937 random(4);
  for (int i = 0; i < 1000; ++i) {
    const LightCosines cosines = RandomCosines(random);
    const LightState light = RandomLight(Lighting::kBlinn, random);
    EXPECT_EQ(Model(light, cosines).specular, cosines.n_dot_h_or_v);
  }
}

TEST(SpecularCosine, PhongSaturatesAndRoundsHalvesUp) {
  const auto specular = [](int64_t l, int64_t v, int64_t l_dot_v) {
    const LightState light = {Lighting::kPhong, {}, {}, Cosine::FromRaw(l_dot_v)};
    return Model(light, {Cosine::FromRaw(l), Cosine::FromRaw(v)}).specular.raw();
  };
  EXPECT_EQ(specular(kOneCosine, kOneCosine, kOneCosine), kOneCosine) << "head on";
  EXPECT_EQ(specular(-2 * kOneCosine, -2 * kOneCosine, -2 * kOneCosine), 2 * kOneCosine - 1);
  EXPECT_EQ(specular(-2 * kOneCosine, 2 * kOneCosine - 1, 2 * kOneCosine - 1), -2 * kOneCosine);
  EXPECT_EQ(specular(1 << 14, 1 << 14, 0), 1) << "2^-31";
  EXPECT_EQ(specular(-(1 << 14), 1 << 14, 0), 0) << "-2^-31";
}

TEST(SpecularCosine, DiffuseClampsAndRounds) {
  const auto diffuse = [](int64_t l) {
    return SpecularCosine::DiffuseOf({Cosine::FromRaw(l), {}}).raw();
  };
  EXPECT_EQ(diffuse(-1), 0);
  EXPECT_EQ(diffuse(-2 * kOneCosine), 0);
  EXPECT_EQ(diffuse((1 << 12) - 1), 0);
  EXPECT_EQ(diffuse(1 << 12), 1);
  EXPECT_EQ(diffuse(kOneCosine - (1 << 12)), 1 << 17);
  EXPECT_EQ(diffuse(kOneCosine - (1 << 12) - 1), (1 << 17) - 1);
  EXPECT_EQ(diffuse(2 * kOneCosine - 1), 1 << 17);
}

}  // namespace
}  // namespace shading
