// SPDX-License-Identifier: Apache-2.0
//
// Pixels of pixel_light that are means of samples: samples of successive pixels back to back.
#include <gtest/gtest.h>

#include <deque>

#include "model/footprint/footprint_mean.h"
#include "model/light/pixel_light.h"
#include "model/light/vertex_light.h"
#include "tb/dut/pixel_light_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/ideal/ideal_stimulus.h"
#include "tests/unit/light/light_stimulus.h"

namespace shading {
namespace {

constexpr int kPixels = 20000;
constexpr int kMaterials = 16;
constexpr int kLatency =
    PixelLight::kContract.latency_cycles + FootprintMean::kContract.latency_cycles;

LightState RandomLight(Lighting lighting, std::mt19937& random) {
  LightState state;
  state.lighting = lighting;
  state.l_dot_v = RandomCosine(random);
  return state;
}

// The light of one sample before it is combined.
FootprintMean::Light LightOf(const LightState& state, const Material& material,
                             const LightCosines& cosines) {
  FootprintMean::Light light;
  light.diffuse = SpecularCosine::DiffuseOf(cosines);
  light.unlit = SpecularCosine::Unlit(cosines);
  bool specular = false;
  for (const Reflectance r : material.specular) specular |= r.raw() != 0;
  if (!specular) return light;
  const Cosine cosine = SpecularCosine(state).Specular(cosines);
  light.highlight = BlinnSpecular(material.shininess).Of(cosine);
  light.skipped = !BlinnSpecular::Lit(cosine);
  return light;
}

template <typename Dut>
class MeanBench {
 public:
  using Input = typename Dut::Input;
  using Output = typename Dut::Output;

  MeanBench(Lighting lighting, Flow flow) : random_(7), pattern_(PatternOf(flow, 4)) {
    light_ = RandomLight(lighting, random_);
    dut_.SetLight(light_);
    dut_.SetMean(true);
    for (int m = 0; m < kMaterials; ++m) {
      materials_.push_back(RandomMaterial(random_, true));
      dut_.SetMaterial(m, materials_.back());
    }
    dut_.Reset();
  }

  // 1, 2, 4 or 7 samples a pixel, each live or not; a pixel comes kLatency after its last sample.
  void Run() {
    int compared = 0, left = 0, sent = 0;
    for (int64_t cycle = 0; compared < kPixels; ++cycle) {
      const bool valid = (sent < kPixels || left > 0) && pattern_.At(cycle);
      if (valid) {
        const bool first = left == 0;
        if (first) Begin(&left, &sent);
        Sample(first, --left == 0, cycle);
      }
      dut_.Cycle(valid, input_);
      const bool due = !expected_.empty() && expected_.front().cycle == cycle + 1;
      ASSERT_EQ(dut_.valid(), due) << "cycle " << cycle;
      if (!due) continue;
      ASSERT_TRUE(dut_.output() == expected_.front().output) << "pixel " << compared;
      expected_.pop_front();
      ++compared;
    }
  }

 private:
  static constexpr size_t kLanes = std::tuple_size_v<Output>;
  struct Expected {
    int64_t cycle;
    Output output;
  };

  void Begin(int* left, int* sent) {
    constexpr int kCounts[] = {1, 2, 4, 7};
    *left = kCounts[random_() % 4];
    ++*sent;
    twice_ = *left == 7;
    input_.material = static_cast<int>(random_() % kMaterials);
    mean_ = {};
  }

  void Sample(bool first, bool last, int64_t cycle) {
    input_.first = first;
    input_.last = last;
    input_.twice = first && twice_;
    input_.live = last ? (1u << kLanes) - 1 : random_() % (1u << kLanes);
    const Material& material = materials_[static_cast<size_t>(input_.material)];
    Expected pixel{cycle + kLatency, {}};
    for (size_t j = 0; j < kLanes; ++j) {
      input_.cosines[j] = RandomCosines(random_);
      if (input_.live >> j & 1) {
        mean_[j].Add(LightOf(light_, material, input_.cosines[j]), input_.twice ? 2 : 1);
      }
      const FootprintMean::Light light = mean_[j].Mean();
      pixel.output[j] = {RgbCombine::Of(light.diffuse, light.highlight, material), light.unlit,
                         light.skipped};
    }
    if (last) expected_.push_back(pixel);
  }

  std::mt19937 random_;
  FlowPattern pattern_;
  Dut dut_;
  LightState light_;
  std::vector<Material> materials_;
  Input input_;
  bool twice_ = false;
  std::array<FootprintMean, kLanes> mean_;
  std::deque<Expected> expected_;
};

using Param = std::tuple<Lighting, Flow>;
class PixelLightMean : public testing::TestWithParam<Param> {};

TEST_P(PixelLightMean, RtlMatchesModel) {
  MeanBench<tb::PixelLightDut>(std::get<0>(GetParam()), std::get<1>(GetParam())).Run();
}
TEST_P(PixelLightMean, RtlOfFourLanesMatchesModel) {
  MeanBench<tb::PixelLight4Dut>(std::get<0>(GetParam()), std::get<1>(GetParam())).Run();
}

INSTANTIATE_TEST_SUITE_P(AllFlows, PixelLightMean,
                         testing::Combine(testing::Values(Lighting::kBlinn, Lighting::kPhong),
                                          testing::Values(Flow::kAlways, Flow::kOneInFour,
                                                          Flow::kRandom)),
                         [](const auto& test) {
                           return testing::PrintToString(std::get<0>(test.param)) +
                                  NameOf(std::get<1>(test.param));
                         });

}  // namespace
}  // namespace shading
