// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/slerp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/ideal/ideal_stimulus.h"

namespace shading::ideal {
namespace {

class IdealSlerp : public testing::TestWithParam<Lighting> {
 protected:
  Vector N(size_t i) const { return Normalised(ToReal(triangle_.n[i])); }
  double X(size_t i) const { return triangle_.x[i].ToReal(); }
  double Y(size_t i) const { return triangle_.y[i].ToReal(); }
  Slerp Make() const { return Slerp(frame_, triangle_); }

  FrameState frame_ = TestFrame(GetParam());
  TrianglePacket triangle_ = TestTriangle();
};

void ExpectNear(const Vector& actual, const Vector& expected, double tolerance) {
  for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance);
}

TEST_P(IdealSlerp, VerticesHaveTheirUnitNormal) {
  for (size_t i = 0; i < 3; ++i) ExpectNear(Make().Normal(X(i), Y(i)), N(i), 1e-12);
  const double middle_x = (X(0) + X(1)) / 2, middle_y = (Y(0) + Y(1)) / 2;
  ExpectNear(Make().Normal(middle_x, middle_y), Normalised(Sum(N(0), N(1))), 1e-12);
}

TEST_P(IdealSlerp, RowsTurnAtUniformSpeed) {
  const Slerp slerp = Make();
  const double first = Dot(slerp.Normal(20.5, 30.5), slerp.Normal(24.5, 30.5));
  EXPECT_NEAR(first, Dot(slerp.Normal(40.5, 30.5), slerp.Normal(44.5, 30.5)), 1e-14);
  EXPECT_LT(first, 1 - 1e-5);
  for (double x = 15; x < 60; x += 3) {
    const Vector n = slerp.Normal(x, 33.25);
    EXPECT_NEAR(Dot(n, n), 1, 1e-14);
  }
}

TEST_P(IdealSlerp, LitByTheFrame) {
  const Slerp slerp = Make();
  EXPECT_EQ(slerp.At(30.5, 40.5),
            Light(frame_).Shade(slerp.Normal(30.5, 40.5), frame_.materials[0]));
}

TEST_P(IdealSlerp, EqualNormalsStayEqual) {
  triangle_.n[1] = triangle_.n[2] = triangle_.n[0];
  for (const double x : {12.0, 30.5, 80.0}) ExpectNear(Make().Normal(x, 40.5), N(0), 1e-15);
}

TEST_P(IdealSlerp, OpposedNormalsTurnThroughTheSmallestAxis) {
  // Down the left edge from +z to -z: x and y tie, x is first.
  triangle_.n = {Quantised({0, 0, 1}), Quantised({0, 0, -1}), Quantised({0, 0, 1})};
  const double middle_x = (X(0) + X(1)) / 2, middle_y = (Y(0) + Y(1)) / 2;
  ExpectNear(Make().Normal(middle_x, middle_y), {1, 0, 0}, 1e-12);
  triangle_.n = {Quantised({0.6, 0, 0.8}), Quantised({-0.6, 0, -0.8}), Quantised({0, 0, 1})};
  ExpectNear(Make().Normal(middle_x, middle_y), {0, 1, 0}, 1e-12);
}

TEST_P(IdealSlerp, ClampsOutside) {
  const Slerp slerp = Make();
  EXPECT_EQ(slerp.Normal(-500, 30.5), slerp.Normal(-900, 30.5));
  ExpectNear(slerp.Normal(0, -100), N(0), 1e-12);
}

TEST_P(IdealSlerp, ZeroNormalFacesTheViewer) {
  triangle_.n = {};
  EXPECT_EQ(Make().Normal(30, 40), (Vector{0, 0, 1}));
}

INSTANTIATE_TEST_SUITE_P(Both, IdealSlerp, testing::Values(Lighting::kBlinn, Lighting::kPhong),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace shading::ideal
