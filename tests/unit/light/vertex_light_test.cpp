// SPDX-License-Identifier: Apache-2.0
#include "model/light/vertex_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/ideal/lighting.h"
#include "model/light/mean_cosines.h"
#include "tests/unit/light/normal_stimulus.h"

namespace shading {
namespace {

constexpr int64_t kFull = int64_t{1} << Reflectance::kFraction;
constexpr int64_t kFullCodes = int64_t{255} << Intensity::kFraction;

Rgb Grey(int64_t raw) {
  const Reflectance r = Reflectance::FromRaw(raw);
  return {r, r, r};
}

Shininess Exponent(int64_t n) { return Shininess::FromRaw(n << Shininess::kFraction); }

FrameState Frame(const Vector3& light, const Vector3& view, Lighting lighting) {
  FrameState frame;
  frame.light = light;
  frame.view = view;
  frame.half = Quantised(light[0].ToReal() + view[0].ToReal(), light[1].ToReal() + view[1].ToReal(),
                         light[2].ToReal() + view[2].ToReal());
  frame.lighting = lighting;
  return frame;
}

double ErrorUlps(const std::array<Intensity, 3>& actual, const ideal::Rgb& ideal) {
  double worst = 0;
  for (size_t c = 0; c < actual.size(); ++c) {
    worst = std::max(worst, std::abs(actual[c].ToReal() - ideal[c]));
  }
  return std::ldexp(worst, Intensity::kFraction);
}

class VertexLightSearch : public testing::TestWithParam<Lighting> {
 protected:
  // A shiny material on a normal near the highlight's peak, where the power is steepest.
  void NextCase() {
    const Vector3 view = RandomNormal(random_);
    frame_ = Frame(Near(view, 0.7, random_), view, GetParam());
    spread_ = std::ldexp(1, -static_cast<int>(random_() % 16));
    material_.ambient = Grey(static_cast<int64_t>(random_() % 1000));
    material_.diffuse = Grey(static_cast<int64_t>(random_() % (kFull + 1)) >> (random_() % 12));
    material_.specular = Grey(kFull - static_cast<int64_t>(random_() % 4));
    const int64_t n = random_() % 2 ? 256 << 7 : 128 + static_cast<int64_t>(random_() % (255 << 7));
    material_.shininess = Shininess::FromRaw(n);
  }
  Vector3 NearPeak() { return Near(frame_.half, spread_, random_); }

  std::mt19937 random_{1};
  FrameState frame_;
  Material material_;
  double spread_ = 0;
};

TEST_P(VertexLightSearch, ModelWithinErrorBound) {
  double worst = 0;
  for (int i = 0; i < 400000; ++i) {
    NextCase();
    const VertexLight light(frame_);
    const Vector3 normal = NearPeak();
    const auto actual = light.Shade(light.Cosines(normal), material_);
    const auto ideal = ideal::Light(frame_).Shade(ideal::ToReal(normal), material_);
    worst = std::max(worst, ErrorUlps(actual, ideal));
  }
  RecordProperty("worst_error_milliulp", static_cast<int>(worst * 1000));
  const bool blinn = GetParam() == Lighting::kBlinn;
  EXPECT_LT(worst, blinn ? 0.52 + 2.01 : VertexLight::kContract.max_error_ulp);
  EXPECT_GT(worst, 1) << "the search is blind";
}

TEST_P(VertexLightSearch, MiddleOfEdgeWithinErrorBound) {
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    NextCase();
    const VertexLight light(frame_);
    const std::array<Vector3, 2> normals = {NearPeak(), NearPeak()};
    const auto mean = MeanCosines::Of(
        normals,
        std::array<LightCosines, 2>{light.Cosines(normals[0]), light.Cosines(normals[1])});
    const ideal::Vector sum = ideal::Sum(ideal::ToReal(normals[0]), ideal::ToReal(normals[1]));
    if (!mean || ideal::Dot(sum, sum) < 1) continue;
    const auto ideal = ideal::Light(frame_).Shade(*ideal::MeanNormal(sum), material_);
    worst = std::max(worst, ErrorUlps(light.Shade(*mean, material_), ideal));
  }
  RecordProperty("worst_error_milliulp", static_cast<int>(worst * 1000));
  EXPECT_LT(worst, GetParam() == Lighting::kBlinn ? 10.6 : 44.5);
}

INSTANTIATE_TEST_SUITE_P(Both, VertexLightSearch,
                         testing::Values(Lighting::kBlinn, Lighting::kPhong),
                         testing::PrintToStringParamName());

const Vector3 kZ = Quantised(0, 0, 1), kAway = Quantised(0, 0, -1), kX = Quantised(1, 0, 0);

int64_t ShadeRaw(const FrameState& frame, const Vector3& normal, const Material& material) {
  const VertexLight light(frame);
  return light.Shade(light.Cosines(normal), material)[0].raw();
}

TEST(VertexLight, FullLightIsExactly255AndClamps) {
  for (const Lighting lighting : {Lighting::kBlinn, Lighting::kPhong}) {
    const FrameState frame = Frame(kZ, kZ, lighting);
    EXPECT_EQ(ShadeRaw(frame, kZ, {Grey(0), Grey(kFull), Grey(0), Exponent(1)}), kFullCodes);
    EXPECT_EQ(ShadeRaw(frame, kZ, {Grey(0), Grey(0), Grey(kFull), Exponent(256)}), kFullCodes);
    EXPECT_EQ(
        ShadeRaw(frame, kZ,
                 {Grey(2 * kFull - 1), Grey(2 * kFull - 1), Grey(2 * kFull - 1), Exponent(1)}),
        kFullCodes);
  }
}

TEST(VertexLight, AwayFromLightOnlyAmbient) {
  const Material material = {Grey(kFull / 4), Grey(kFull), Grey(kFull), Exponent(8)};
  EXPECT_EQ(ShadeRaw(Frame(kZ, kZ, Lighting::kBlinn), kAway, material), kFullCodes / 4);
  EXPECT_EQ(ShadeRaw(Frame(kZ, kZ, Lighting::kBlinn), kX, material), kFullCodes / 4);
}

TEST(VertexLight, HighlightIsNotGatedByDiffuse) {
  // N.L = 0 while N.H = sqrt(1/2).
  const FrameState frame = Frame(kX, kZ, Lighting::kBlinn);
  const Material material = {Grey(0), Grey(kFull), Grey(kFull), Exponent(2)};
  EXPECT_NEAR(static_cast<double>(ShadeRaw(frame, kZ, material)), kFullCodes * 0.5, 4);
}

TEST(VertexLight, PhongReflectsAboutNormal) {
  // 30 degrees between L and V, N at L: R = L, R.V = cos 30.
  const Vector3 light = Quantised(0.5, 0, std::sqrt(0.75));
  const FrameState frame = Frame(light, kZ, Lighting::kPhong);
  const Material material = {Grey(0), Grey(0), Grey(kFull), Exponent(2)};
  EXPECT_NEAR(static_cast<double>(ShadeRaw(frame, light, material)), kFullCodes * 0.75, 8);
}

TEST(VertexLight, ReflectionIsRoundedOnce) {
  // L = V, so that R.V = 2 (N.L)(N.V) - 1 and half an ulp of S1.30 is all that n = 256 magnifies.
  const VertexLight light(Frame(kZ, kZ, Lighting::kPhong));
  const Material material = {Grey(0), Grey(0), Grey(kFull), Exponent(256)};
  std::mt19937 random(2);
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    const Cosine n_dot_l = Cosine::FromRaw((1 << 30) - static_cast<int64_t>(random() % 100000));
    const Cosine n_dot_v = Cosine::FromRaw((1 << 30) - static_cast<int64_t>(random() % 100000));
    const double ideal = 255 * std::pow(2 * n_dot_l.ToReal() * n_dot_v.ToReal() - 1, 256);
    const auto actual = light.Shade({n_dot_l, n_dot_v}, material);
    worst = std::max(worst, ErrorUlps(actual, {ideal, ideal, ideal}));
  }
  EXPECT_LT(worst, 0.52 + 2.01);
}

TEST(VertexLight, ChannelsAreIndependent) {
  Material material;
  material.diffuse[1] = Reflectance::FromRaw(kFull / 2);
  material.ambient[2] = Reflectance::FromRaw(kFull / 4);
  const VertexLight light(Frame(kZ, kZ, Lighting::kBlinn));
  const auto codes = light.Shade(light.Cosines(kZ), material);
  EXPECT_EQ(codes[0].raw(), 0);
  EXPECT_EQ(codes[1].raw(), kFullCodes / 2);
  EXPECT_EQ(codes[2].raw(), kFullCodes / 4);
}

TEST(VertexLight, LongVectorsSaturate) {
  const NormalComponent least = NormalComponent::FromRaw(-(int64_t{1} << 23));
  const Vector3 corner = {least, least, least};
  FrameState frame;
  frame.light = frame.half = frame.view = corner;
  for (const Lighting lighting : {Lighting::kBlinn, Lighting::kPhong}) {
    frame.lighting = lighting;
    EXPECT_EQ(VertexLight(frame).Cosines(corner).n_dot_l.raw(), (int64_t{1} << 31) - 1);
    EXPECT_EQ(ShadeRaw(frame, corner, {Grey(0), Grey(kFull), Grey(kFull), Exponent(3)}),
              kFullCodes);
  }
}

}  // namespace
}  // namespace shading
