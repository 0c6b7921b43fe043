// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/footprint.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/ideal/phong.h"
#include "tests/unit/ideal/ideal_stimulus.h"

namespace shading::ideal {
namespace {

constexpr double kPi = 3.14159265358979323846;

double WorstChannel(const Rgb& a, const Rgb& b) {
  double worst = 0;
  for (size_t c = 0; c < a.size(); ++c) worst = std::max(worst, std::abs(a[c] - b[c]));
  return worst;
}

TEST(IdealFootprint, EqualNormalsAreNotBlurred) {
  FrameState frame = TestFrame(Lighting::kBlinn);
  TrianglePacket triangle = TestTriangle();
  triangle.n[1] = triangle.n[2] = triangle.n[0];
  const Rgb expected = Phong(frame, triangle).At(30.5, 40.5);
  EXPECT_LT(WorstChannel(Footprint(frame, triangle).At(30.5, 40.5), expected), 1e-9);
  EXPECT_LT(WorstChannel(PaperFootprint(frame, triangle).At(30.5, 40.5), expected), 1e-9);
}

// A plane that is seen at a slant, with a normal that turns on it: the ellipse is built on the
// plane, from its own axes and with points that are spread evenly there.
struct SlantedPlane {
  Vector u, v, n;  // orthonormal; u is the direction of the slant
  Vector origin = {50, 60, 0};

  SlantedPlane(double slant, double tilt) {
    n = {std::sin(slant) * std::cos(tilt), std::sin(slant) * std::sin(tilt), std::cos(slant)};
    v = {-std::sin(tilt), std::cos(tilt), 0};
    u = {v[1] * n[2] - v[2] * n[1], v[2] * n[0] - v[0] * n[2], v[0] * n[1] - v[1] * n[0]};
  }
  Vector Point(double s, double t) const { return Sum(origin, Sum(Scaled(s, u), Scaled(t, v))); }
};

// Corners on the plane, and normals that change linearly on it.
TrianglePacket OnPlane(const SlantedPlane& plane,
                       const std::array<std::array<double, 2>, 3>& corner) {
  TrianglePacket triangle = TestTriangle();
  for (size_t i = 0; i < 3; ++i) {
    const Vector p = plane.Point(corner[i][0], corner[i][1]);
    triangle.x[i] = ScreenCoord::Round(p[0]);
    triangle.y[i] = ScreenCoord::Round(p[1]);
    triangle.n[i] = Quantised(
        Sum(plane.n, Sum(Scaled(corner[i][0] / 60, plane.u), Scaled(corner[i][1] / 90, plane.v))));
  }
  return triangle;
}

TEST(IdealFootprint, DiscOnTheScreenIsTheEllipseOnTheSurface) {
  const FrameState frame = TestFrame(Lighting::kBlinn);
  const std::array<std::array<double, 2>, 3> corner = {{{-40, -20}, {45, -25}, {5, 30}}};
  for (const double slant : {0.2, 1.0, 1.4}) {
    const SlantedPlane plane(slant, 0.7);
    const TrianglePacket triangle = OnPlane(plane, corner);
    const Footprint footprint(frame, triangle);
    const Light light(frame);
    // Semi-axes: r / cos(slant) along u, r along v.
    Rgb sum = {};
    int count = 0;
    for (int i = -32; i < 32; ++i) {
      for (int j = -32; j < 32; ++j) {
        const double a = (i + 0.5) / 32, b = (j + 0.5) / 32;
        if (a * a + b * b > 1) continue;
        const Vector p =
            plane.Point(a * Footprint::kRadius / std::cos(slant), b * Footprint::kRadius);
        sum = Sum(sum, light.Shade(Normalised(footprint.Normal(p[0], p[1])), frame.materials[0]));
        ++count;
      }
    }
    const Vector centre = plane.Point(0, 0);
    EXPECT_LT(WorstChannel(footprint.At(centre[0], centre[1]), Scaled(1.0 / count, sum)), 0.02)
        << slant;
  }
}

// Of a quadratic the mean over the disc is the centre + r^2 (A + B) / 4.
TEST(IdealFootprint, DiscHasTheMomentsOfAPixel) {
  EXPECT_NEAR(Footprint::kRadius * Footprint::kRadius / 4, 1.0 / 12, 1e-15);
  double xx = 0, xy = 0, yy = 0;
  for (int ring = 0; ring < Footprint::kRings; ++ring) {
    const double r2 = Footprint::kRadius * Footprint::kRadius * (ring + 0.5) / Footprint::kRings;
    for (int spoke = 0; spoke < Footprint::kSpokes; ++spoke) {
      const double angle = 2 * kPi * spoke / Footprint::kSpokes;
      xx += r2 * std::cos(angle) * std::cos(angle) / 4096;
      xy += r2 * std::cos(angle) * std::sin(angle) / 4096;
      yy += r2 * std::sin(angle) * std::sin(angle) / 4096;
    }
  }
  EXPECT_NEAR(xx, 1.0 / 12, 1e-12);
  EXPECT_NEAR(yy, 1.0 / 12, 1e-12);
  EXPECT_NEAR(xy, 0, 1e-12);
}

// The point of the surface that a ray meets, against interpolation with 1 / distance.
TEST(IdealFootprint, PerspectiveIsInterpolationOnTheSurface) {
  const FrameState frame = TestFrame(Lighting::kBlinn);
  const std::array<Vector, 3> corner = {{{-3, -2, -9}, {4, -1, -14}, {1, 5, -6}}};
  TrianglePacket triangle = TestTriangle();
  constexpr double kScale = 64;
  std::array<double, 3> distance;
  for (size_t i = 0; i < 3; ++i) {
    distance[i] = -corner[i][2];
    triangle.x[i] = ScreenCoord::Round(kScale * corner[i][0] / distance[i] + 100);
    triangle.y[i] = ScreenCoord::Round(kScale * corner[i][1] / distance[i] + 100);
  }
  const Footprint footprint(frame, triangle, distance);
  for (const auto& [a, b] : {std::pair{0.2, 0.3}, {0.6, 0.1}, {0.1, 0.8}, {1.2, -0.1}}) {
    const std::array<double, 3> weight = {a, b, 1 - a - b};
    Vector p = {}, n = {};
    for (size_t i = 0; i < 3; ++i) {
      p = Sum(p, Scaled(weight[i], corner[i]));
      n = Sum(n, Scaled(weight[i], ToReal(triangle.n[i])));
    }
    const Vector on_screen =
        footprint.Normal(kScale * p[0] / -p[2] + 100, kScale * p[1] / -p[2] + 100);
    EXPECT_GT(Dot(Normalised(on_screen), Normalised(n)), 1 - 1e-5);
  }
}

TEST(IdealFootprint, PaperEnlargesTheTriangle) {
  const FrameState frame = TestFrame(Lighting::kBlinn);
  TrianglePacket t = TestTriangle();
  const PaperFootprint paper(frame, t);
  const auto x = [&](size_t i) { return t.x[i].ToReal(); };
  const auto y = [&](size_t i) { return t.y[i].ToReal(); };
  for (size_t i = 0; i < 3; ++i) {
    const size_t before = (i + 2) % 3;
    const double cx = 2 * x(i) - x(before), cy = 2 * y(i) - y(before);
    EXPECT_NEAR(paper.Weights(cx, cy)[i], 1, 1e-12);
    EXPECT_NEAR(Dot(paper.Normal(cx, cy), paper.Normal(cx, cy)), 1, 1e-5) << "unit length is kept";
    // The vertex lies half-way between B' and A: its normal is half-way between N_A and N_B'.
    const Vector middle = Normalised(Sum(paper.Normal(cx, cy), ToReal(t.n[before])));
    EXPECT_GT(Dot(middle, Normalised(ToReal(t.n[i]))), 1 - 1e-6);
    EXPECT_FALSE(paper.Outside(x(i), y(i)));
    EXPECT_TRUE(paper.Outside(cx + 0.3 * (cx - 38), cy + 0.3 * (cy - 40)));
  }
  EXPECT_TRUE(PaperFootprint(frame, t).Subdivides());
  t.n = {Quantised({0.2, 0.1, 1}), Quantised({-0.2, 0.1, 1}), Quantised({0, -0.2, 1})};
  EXPECT_FALSE(PaperFootprint(frame, t).Subdivides());
  t.n = {Quantised({1, 0, 1}), Quantised({-1, 0, 1}), Quantised({0, 1, 0.2})};
  EXPECT_TRUE(PaperFootprint(frame, t).Subdivides());
}

}  // namespace
}  // namespace shading::ideal
