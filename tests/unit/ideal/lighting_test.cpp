// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/lighting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/ideal/ideal_stimulus.h"

namespace shading::ideal {
namespace {

Material OnlySpecular(double n) {
  return {Colour(0, 0, 0), Colour(0, 0, 0), Colour(1, 1, 1), Shininess::Round(n)};
}

FrameState SimpleFrame(const Vector& light, const Vector& view, Lighting lighting) {
  FrameState frame;
  frame.light = Quantised(light);
  frame.view = Quantised(view);
  frame.half = Quantised(Sum(Normalised(light), Normalised(view)));
  frame.lighting = lighting;
  return frame;
}

TEST(IdealLight, SumsThreeTerms) {
  // N.L = 0.6, N.H = 1: cosines of the axes are exact.
  FrameState frame;
  frame.light = {NormalComponent::Round(0.8), NormalComponent(), NormalComponent::Round(0.6)};
  frame.half = Quantised({0, 0, 1});
  const Material material = {Colour(0.125, 0, 0), Colour(0.5, 0.5, 0), Colour(0.25, 0, 0.75),
                             Shininess::Round(10)};
  const Rgb codes = Light(frame).Shade({0, 0, 1}, material);
  EXPECT_NEAR(codes[0], 255 * (0.125 + 0.3 + 0.25), 1e-4);
  EXPECT_NEAR(codes[1], 255 * 0.3, 1e-4);
  EXPECT_NEAR(codes[2], 255 * 0.75, 1e-4);
}

TEST(IdealLight, BlinnAndPhongHighlights) {
  // L, V 60 degrees apart and N = V: N.H = cos 30, R.V = cos 60.
  const Vector light = {std::sqrt(0.75), 0, 0.5}, view = {0, 0, 1};
  const Rgb blinn = Light(SimpleFrame(light, view, Lighting::kBlinn)).Shade(view, OnlySpecular(4));
  const Rgb phong = Light(SimpleFrame(light, view, Lighting::kPhong)).Shade(view, OnlySpecular(4));
  EXPECT_NEAR(blinn[0], 255 * 0.5625, 1e-3);
  EXPECT_NEAR(phong[0], 255 * 0.0625, 1e-3);
}

TEST(IdealLight, HighlightIsNotGatedByDiffuse) {
  const FrameState frame = SimpleFrame({1, 0, 0}, {0, 0, 1}, Lighting::kBlinn);
  EXPECT_NEAR(Light(frame).Shade({0, 0, 1}, OnlySpecular(2))[0], 255 * 0.5, 1e-3);
}

TEST(IdealLight, ClampsCosinesAndSum) {
  const FrameState frame = SimpleFrame({0, 0, 1}, {0, 0, 1}, Lighting::kBlinn);
  Material material = OnlySpecular(256);
  material.specular = Colour(0.5, 0.5, 0.5);
  EXPECT_EQ(Light(frame).Shade({0, 0, 1.0009765625}, material)[0], 127.5);
  EXPECT_EQ(Light(frame).Shade({0, 0, -1}, material)[0], 0);
  material.diffuse = Colour(0.25, 0.25, 0);
  EXPECT_EQ(Light(frame).Shade({0, 0, 1.0009765625}, material)[0], 191.25);
  material.diffuse = Colour(1, 0.25, 0);
  EXPECT_EQ(Light(frame).Shade({0, 0, 1}, material), (Rgb{255, 191.25, 127.5}));
}

TEST(IdealLight, MeanNormalIsUndefinedWhenOpposed) {
  EXPECT_FALSE(MeanNormal({0, 0, 0.03124}));
  const auto mean = MeanNormal({0, 0, 0.03125});
  ASSERT_TRUE(mean);
  EXPECT_EQ(*mean, (Vector{0, 0, 1}));
  EXPECT_EQ(Normalised({0, 0, 0}), (Vector{0, 0, 0}));
}

}  // namespace
}  // namespace shading::ideal
