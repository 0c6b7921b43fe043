// SPDX-License-Identifier: Apache-2.0
#include "model/light/pixel_light.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <tuple>
#include <vector>

#include "model/ideal/lighting.h"
#include "tb/dut/pixel_light_dut.h"
#include "tests/unit/light/light_stimulus.h"
#include "tests/unit/light/normal_stimulus.h"

namespace shading {
namespace {

constexpr int kFrames = 4, kGroups = 40000;

FrameState RandomFrame(Lighting lighting, std::mt19937& random) {
  FrameState frame;
  frame.view = RandomNormal(random);
  frame.light = Near(frame.view, 0.7, random);
  frame.half = Quantised(frame.light[0].ToReal() + frame.view[0].ToReal(),
                         frame.light[1].ToReal() + frame.view[1].ToReal(),
                         frame.light[2].ToReal() + frame.view[2].ToReal());
  frame.lighting = lighting;
  return frame;
}

using Param = std::tuple<Lighting, Flow>;
class PixelLightFlow : public testing::TestWithParam<Param> {
 protected:
  // Frames with a full material table, the material changing from group to group.
  template <typename Dut>
  void ExpectSame() {
    const auto [lighting, flow] = GetParam();
    std::mt19937 random(1);
    Dut dut;
    for (int frame = 0; frame < kFrames; ++frame) {
      const LightState light = LightOf(RandomFrame(lighting, random));
      dut.SetLight(light);
      std::vector<PixelLight> materials;
      for (int m = 0; m < static_cast<int>(kMaxMaterials); ++m) {
        const Material material = RandomMaterial(random, true);
        dut.SetMaterial(m, material);
        materials.emplace_back(light).SetMaterial(material);
      }
      dut.Reset();
      ExpectSameStream(
          &dut, PatternOf(flow, 2), kGroups, [&] { return RandomInput<Dut>(random); },
          [&](const typename Dut::Input& input) { return Model<Dut>(materials, input); });
    }
  }

 private:
  template <typename Dut>
  static typename Dut::Input RandomInput(std::mt19937& random) {
    typename Dut::Input input;
    input.material = static_cast<int>(random() % kMaxMaterials);
    for (LightCosines& cosines : input.cosines) cosines = RandomCosines(random);
    return input;
  }
  template <typename Dut>
  static typename Dut::Output Model(const std::vector<PixelLight>& materials,
                                    const typename Dut::Input& input) {
    typename Dut::Output lanes;
    for (size_t j = 0; j < lanes.size(); ++j) {
      const PixelLight::Report report =
          materials[static_cast<size_t>(input.material)].ShadeAndReport(input.cosines[j]);
      lanes[j] = {report.codes, report.unlit, report.no_highlight};
    }
    return lanes;
  }
};

TEST_P(PixelLightFlow, RtlMatchesModel) { ExpectSame<tb::PixelLightDut>(); }
TEST_P(PixelLightFlow, RtlOfFourLanesMatchesModel) { ExpectSame<tb::PixelLight4Dut>(); }

INSTANTIATE_TEST_SUITE_P(AllFlows, PixelLightFlow,
                         testing::Combine(testing::Values(Lighting::kBlinn, Lighting::kPhong),
                                          testing::Values(Flow::kAlways, Flow::kOneInFour,
                                                          Flow::kRandom)),
                         [](const auto& test) {
                           return testing::PrintToString(std::get<0>(test.param)) +
                                  NameOf(std::get<1>(test.param));
                         });

TEST(PixelLight, ContractMatchesRtl) {
  ExpectTiming<tb::PixelLightDut>(PixelLight::kContract, {});
  ExpectTiming<tb::PixelLight4Dut>(PixelLight::kContract, {});
}

class PixelLightSearch : public testing::TestWithParam<Lighting> {
 protected:
  // The worst |code - ideal| for normals of a length near 1 about the highlight's peak, where the
  // power is steepest.
  double WorstError(double longest, int cases) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> length(2 - longest, longest);
    double worst = 0;
    for (int i = 0; i < cases; ++i) {
      const FrameState frame = RandomFrame(GetParam(), random);
      const ideal::Light ideal(frame);
      const LightState state = LightOf(frame);
      PixelLight light(state);
      const Material material = RandomMaterial(random);
      light.SetMaterial(material);
      for (int pixel = 0; pixel < 16; ++pixel) {
        const double spread = std::ldexp(1, -static_cast<int>(random() % 10));
        ideal::Vector normal = ideal::Normalised(ideal::ToReal(Near(frame.half, spread, random)));
        normal = ideal::Scaled(longest > 1 ? length(random) : 1, normal);
        const LightCosines cosines = {
            Cosine::Round(ideal::Dot(normal, ideal::ToReal(state.light))),
            Cosine::Round(ideal::Dot(normal, ideal::ToReal(state.half_or_view)))};
        const PixelCodes codes = light.Shade(cosines);
        const ideal::Rgb expected = ideal.Shade(normal, material);
        worst = std::max({worst, std::abs(codes.r - expected[0]), std::abs(codes.g - expected[1]),
                          std::abs(codes.b - expected[2])});
      }
    }
    return worst;
  }
};

TEST_P(PixelLightSearch, ModelWithinErrorBound) {
  const double worst = WorstError(1, 60000);
  RecordProperty("worst_error_millicodes", static_cast<int>(worst * 1000));
  EXPECT_LE(worst, PixelLight::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.5005) << "the search is blind";
}

// Cosines over 1 are clamped before the power, in model and closed form alike.
TEST_P(PixelLightSearch, OvershootStaysWithinErrorBound) {
  const double worst = WorstError(1.001, 30000);
  EXPECT_LE(worst, PixelLight::kContract.max_error_ulp);
}

INSTANTIATE_TEST_SUITE_P(Both, PixelLightSearch,
                         testing::Values(Lighting::kBlinn, Lighting::kPhong),
                         testing::PrintToStringParamName());

class PixelLightBlocks : public testing::TestWithParam<Lighting> {
 protected:
  // A block of `count` pixels, and every one of them by itself.
  void ExpectSame(const PixelLight& light, const BlinnSpecular& power, int count) {
    PixelLight::Report expected[PixelLightBlock::kSize];
    int unlit = 0, no_highlight = 0;
    for (int i = 0; i < count; ++i) {
      LightCosines cosines = RandomCosines(random_);
      if (random_() % 8 == 0) {
        const int64_t edge = power.least_visible().raw() + static_cast<int64_t>(random_() % 5) - 2;
        cosines.n_dot_h_or_v = Cosine::FromRaw(edge);
      }
      block_.SetCosines(static_cast<size_t>(i), cosines);
      expected[i] = light.ShadeAndReport(cosines);
      unlit += expected[i].unlit;
      no_highlight += expected[i].no_highlight;
    }
    const auto counts = light.ShadeBlock(static_cast<size_t>(count), &block_);
    ASSERT_EQ(counts.unlit, unlit);
    ASSERT_EQ(counts.no_highlight, no_highlight);
    for (int i = 0; i < count; ++i) {
      const PixelCodes& codes = expected[i].codes;
      ASSERT_EQ(block_.codes(static_cast<size_t>(i)), codes.r | codes.g << 8 | codes.b << 16)
          << "pixel " << i << " of " << count;
    }
  }

  // Every length of a block, for one shininess; the materials vary.
  void ExpectSameLengths(Shininess shininess) {
    PixelLight light(LightOf(RandomFrame(GetParam(), random_)));
    const BlinnSpecular power(shininess);
    for (int count = 1; count <= PixelLightBlock::kSize; ++count) {
      Material material = RandomMaterial(random_, true);
      material.shininess = shininess;
      light.SetMaterial(material);
      ExpectSame(light, power, count);
    }
  }

  std::mt19937 random_{1};
  PixelLightBlock block_;
};

TEST_P(PixelLightBlocks, EqualPixels) {
  for (int pass = 0; pass < 3; ++pass) {
    for (int n = 1; n <= 256; ++n) ExpectSameLengths(Shininess::FromRaw(n * kLeastShininess));
    for (int n = 0; n < 128; ++n) ExpectSameLengths(RandomShininess(random_));
  }
}

TEST_P(PixelLightBlocks, EqualPixelsForEveryShininess) {
  ExpectSameLengths(Shininess::FromRaw(0));
  ExpectSameLengths(Shininess::FromRaw(Shininess::kMaxRaw));
  for (int n = 0; n < 256; ++n) {
    ExpectSameLengths(Shininess::FromRaw(random_() % (Shininess::kMaxRaw + 1)));
  }
}

INSTANTIATE_TEST_SUITE_P(Both, PixelLightBlocks,
                         testing::Values(Lighting::kBlinn, Lighting::kPhong),
                         testing::PrintToStringParamName());

Rgb Grey(int64_t raw) {
  const Reflectance r = Reflectance::FromRaw(raw);
  return {r, r, r};
}

TEST(PixelLight, ReportsUnlitAndNoHighlight) {
  PixelLight light(LightState{});
  const auto report = [&light](int64_t l, int64_t h) {
    return light.ShadeAndReport({Cosine::FromRaw(l), Cosine::FromRaw(h)});
  };
  light.SetMaterial({Grey(0), Grey(65536), Grey(1), Shininess::FromRaw(kMostShininess)});
  EXPECT_TRUE(report(0, 0).unlit);
  EXPECT_FALSE(report(1, 0).unlit);
  EXPECT_TRUE(report(1, 0).no_highlight);
  EXPECT_FALSE(report(1, 1).no_highlight) << "computed, although it rounds to 0";
  light.SetMaterial({Grey(0), Grey(65536), Grey(0), Shininess::FromRaw(kMostShininess)});
  EXPECT_TRUE(report(1, kOneCosine).no_highlight) << "nothing reflects it";
}

TEST(PixelLight, HighlightIsNotGatedByDiffuse) {
  PixelLight light(LightState{});
  light.SetMaterial({Grey(0), Grey(65536), Grey(65536), Shininess::FromRaw(kLeastShininess)});
  const PixelCodes white = {255, 255, 255};
  EXPECT_EQ(light.Shade({Cosine::FromRaw(-kOneCosine), Cosine::FromRaw(kOneCosine)}), white);
}

}  // namespace
}  // namespace shading
