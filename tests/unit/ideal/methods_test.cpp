// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "model/ideal/flat.h"
#include "model/ideal/gouraud.h"
#include "model/ideal/phong.h"
#include "model/ideal/quadratic.h"
#include "tests/unit/ideal/ideal_stimulus.h"

namespace shading::ideal {
namespace {

// The quantised normals are unit within 2^-22, which the highlight magnifies.
constexpr double kQuantisation = 1e-3;

void ExpectNear(const Rgb& actual, const Rgb& expected, double tolerance) {
  for (size_t c = 0; c < actual.size(); ++c) EXPECT_NEAR(actual[c], expected[c], tolerance);
}

class IdealMethods : public testing::TestWithParam<Lighting> {
 protected:
  double X(size_t i) const { return triangle_.x[i].ToReal(); }
  double Y(size_t i) const { return triangle_.y[i].ToReal(); }
  Vector N(size_t i) const { return ToReal(triangle_.n[i]); }
  Rgb Lit(const Vector& normal) const { return Light(frame_).Shade(normal, frame_.materials[0]); }

  FrameState frame_ = TestFrame(GetParam());
  TrianglePacket triangle_ = TestTriangle();
};

TEST_P(IdealMethods, WeightsAreOneAtTheirVertex) {
  const Barycentric barycentric(triangle_);
  for (size_t i = 0; i < 3; ++i) {
    Barycentric::Weights unit = {};
    unit[i] = 1;
    EXPECT_EQ(barycentric.At(X(i), Y(i)), unit);
  }
  const auto weight = barycentric.AtPixel(30, 40);
  EXPECT_NEAR(weight[0] + weight[1] + weight[2], 1, 1e-15);
  EXPECT_NEAR(weight[0] * X(0) + weight[1] * X(1) + weight[2] * X(2), 30.5, 1e-12);
  EXPECT_NEAR(weight[0] * Y(0) + weight[1] * Y(1) + weight[2] * Y(2), 40.5, 1e-12);
}

TEST_P(IdealMethods, SliverWeightsAreExact) {
  // 11 000 pixels long, of area 2^-17: in raw coordinates the doubled area is -1, so the weights
  // are integers.
  const int64_t bx = 1 << 20, by = bx - 1, cx = 2 * bx - 1, cy = 2 * bx - 3;
  triangle_.x = {ScreenCoord(), ScreenCoord::FromRaw(bx), ScreenCoord::FromRaw(cx)};
  triangle_.y = {ScreenCoord(), ScreenCoord::FromRaw(by), ScreenCoord::FromRaw(cy)};
  ASSERT_EQ(bx * cy - cx * by, -1);
  const int64_t x = 4000 * 256 + 128, y = 3999 * 256 + 128;
  const auto weight = Barycentric(triangle_).AtPixel(4000, 3999);
  EXPECT_EQ(weight[1], static_cast<double>(cx * y - x * cy));
  EXPECT_EQ(weight[2], static_cast<double>(x * by - bx * y));
  EXPECT_EQ(weight[0] + weight[1] + weight[2], 1);
}

TEST_P(IdealMethods, FlatIsLightOfMeanNormal) {
  const Flat flat(frame_, triangle_);
  const Rgb expected = Lit(Normalised(Sum(N(0), Sum(N(1), N(2)))));
  ExpectNear(flat.At(20, 20), expected, 1e-12);
  EXPECT_EQ(flat.At(20, 20), flat.At(70, 41));
}

TEST_P(IdealMethods, FlatFallsBackToFirstVertex) {
  triangle_.n = {Quantised({0, 0.6, 0.8}), Quantised({0, -0.6, -0.8}), Vector3{}};
  EXPECT_EQ(Flat(frame_, triangle_).At(0, 0), Lit(N(0)));
}

TEST_P(IdealMethods, GouraudIsAffineThroughVertices) {
  const Gouraud gouraud(frame_, triangle_);
  for (size_t i = 0; i < 3; ++i) ExpectNear(gouraud.At(X(i), Y(i)), Lit(N(i)), 1e-12);
  const Rgb a = gouraud.At(12, 30), b = gouraud.At(52, 44), middle = gouraud.At(32, 37);
  ExpectNear(middle, Scaled(0.5, Sum(a, b)), 1e-10);
}

TEST_P(IdealMethods, QuadraticReproducesSixNodes) {
  const Quadratic quadratic(frame_, triangle_);
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3;
    ExpectNear(quadratic.AtUnclamped(X(i), Y(i)), Lit(N(i)), 1e-11);
    ExpectNear(quadratic.AtUnclamped((X(i) + X(j)) / 2, (Y(i) + Y(j)) / 2),
               Lit(Normalised(Sum(N(i), N(j)))), 1e-11);
  }
}

TEST_P(IdealMethods, QuadraticHasNoThirdDifference) {
  const Quadratic quadratic(frame_, triangle_);
  const auto at = [&](int step) { return quadratic.AtUnclamped(15 + 5 * step, 20 + 3 * step); };
  const Rgb difference =
      Sum(Sum(at(3), Scaled(-3, at(2))), Sum(Scaled(3, at(1)), Scaled(-1, at(0))));
  ExpectNear(difference, {}, 1e-10);
  const Rgb second = Sum(at(2), Sum(Scaled(-2, at(1)), at(0)));
  EXPECT_GT(std::abs(second[2]), 0.1) << "the highlight bends the surface";
}

TEST_P(IdealMethods, QuadraticEdgeOfOpposedNormalsIsStraight) {
  triangle_.n[1] = Quantised(Scaled(-1, N(0)));
  const double x = (X(0) + X(1)) / 2, y = (Y(0) + Y(1)) / 2;
  ExpectNear(Quadratic(frame_, triangle_).AtUnclamped(x, y), Gouraud(frame_, triangle_).At(x, y),
             1e-11);
}

TEST_P(IdealMethods, QuadraticClampsOnlyTheOutput) {
  // A highlight on one edge alone: the surface dips under 0 beyond the opposite vertex.
  triangle_.n = {Quantised({-0.9, 0, 0.3}), Quantised({0.9, 0.4, 0.3}), Quantised({0, -1, 0})};
  const Quadratic quadratic(frame_, triangle_);
  double least = 0;
  for (int y = 8; y < 70; ++y) {
    for (int x = 10; x < 90; ++x) {
      const Rgb free = quadratic.AtUnclamped(x, y), shown = quadratic.At(x, y);
      for (size_t c = 0; c < free.size(); ++c) {
        least = std::min(least, free[c]);
        EXPECT_EQ(shown[c], std::clamp(free[c], 0.0, 255.0));
      }
    }
  }
  EXPECT_LT(least, -1);
}

TEST_P(IdealMethods, PhongAtVerticesIsVertexLight) {
  const Phong phong(frame_, triangle_);
  for (size_t i = 0; i < 3; ++i) {
    ExpectNear(phong.At(X(i), Y(i)), Lit(N(i)), kQuantisation);
    const size_t j = (i + 1) % 3;
    ExpectNear(phong.At((X(i) + X(j)) / 2, (Y(i) + Y(j)) / 2), Lit(Normalised(Sum(N(i), N(j)))),
               kQuantisation);
  }
}

TEST_P(IdealMethods, PhongNormalisesPerPixel) {
  const Phong phong(frame_, triangle_);
  const auto weight = Barycentric(triangle_).AtPixel(35, 40);
  const Vector normal =
      Sum(Scaled(weight[0], N(0)), Sum(Scaled(weight[1], N(1)), Scaled(weight[2], N(2))));
  ExpectNear(phong.At(35.5, 40.5), Lit(Normalised(normal)), 1e-11);
  EXPECT_GT(std::abs(phong.At(35.5, 40.5)[2] - Lit(normal)[2]), 0.1);
}

TEST_P(IdealMethods, ConstantNormalsGiveConstantPicture) {
  triangle_.n[1] = triangle_.n[2] = triangle_.n[0];
  const Rgb expected = Lit(N(0));
  for (const auto& [x, y] : {std::pair(20.5, 20.5), std::pair(40.5, 41.5), std::pair(14.5, 60.5)}) {
    ExpectNear(Flat(frame_, triangle_).At(x, y), expected, kQuantisation);
    ExpectNear(Gouraud(frame_, triangle_).At(x, y), expected, 1e-11);
    ExpectNear(Quadratic(frame_, triangle_).At(x, y), expected, kQuantisation);
    ExpectNear(Phong(frame_, triangle_).At(x, y), expected, kQuantisation);
  }
}

TEST_P(IdealMethods, UnknownMaterialThrows) {
  triangle_.material = 1;
  EXPECT_THROW(Flat(frame_, triangle_), std::out_of_range);
}

INSTANTIATE_TEST_SUITE_P(Both, IdealMethods, testing::Values(Lighting::kBlinn, Lighting::kPhong),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace shading::ideal
