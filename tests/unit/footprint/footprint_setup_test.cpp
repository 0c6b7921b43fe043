// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/footprint_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/unit/footprint/footprint_stimulus.h"

namespace shading {
namespace {

using ideal::Vector;

// A disc that spans half a barycentric at most.
double RadiusOf(const TrianglePacket& packet) {
  std::array<double, 3> x, y;
  double longest = 0;
  for (size_t i = 0; i < 3; ++i) x[i] = packet.x[i].ToReal(), y[i] = packet.y[i].ToReal();
  for (size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, std::hypot(x[(i + 1) % 3] - x[i], y[(i + 1) % 3] - y[i]));
  }
  const double area = std::abs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
  return std::min(kRadius, area / longest / 2);
}

// The normals' second moments over a disc, sum of offset offset' by weight, are those of the
// samples, whatever axes were chosen. In ulp of S1.28 for the offset itself.
double MomentError(const FootprintCase& c, const std::array<Vector, 2>& slope,
                   FootprintPattern pattern) {
  const double radius = RadiusOf(c.packet);
  double worst = 0, scale = 0;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) {
      double moment = 0;
      const double total = pattern == FootprintPattern::kFour ? 4 : 8;
      for (size_t k = 0; k < 3; ++k) moment += 2 * c.Offset(k)[i] * c.Offset(k)[j] / total;
      const double expected =
          radius * radius / 4 * (slope[0][i] * slope[0][j] + slope[1][i] * slope[1][j]);
      worst = std::max(worst, std::abs(moment - expected));
      scale = std::max(scale, std::sqrt(std::abs(expected)));
    }
  }
  return scale < 1e-9 ? 0 : std::ldexp(worst / scale, 28);
}

TEST(FootprintSetup, ModelWithinErrorBound) {
  std::mt19937 random(1);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(std::ldexp(100, -(i % 6)), random));
    packet.n = NormalsWithin(std::ldexp(0.7, -(i % 9)), random);
    for (const auto pattern : {FootprintPattern::kFour, FootprintPattern::kEight}) {
      FootprintCase c;
      if (!c.Make(packet, SetupOf(FootprintForm::kSeamless, pattern))) continue;
      const ideal::Footprint field(c.frame, packet);
      worst = std::max(worst, MomentError(c, Slopes(field), pattern));
    }
  }
  std::printf("second moments: %.3f ulp of S1.28\n", worst);
  EXPECT_LE(worst, FootprintSetup::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.1 * FootprintSetup::kContract.max_error_ulp) << "the search is blind";
}

// Two samples lie where the normal turns most: no direction on the screen turns it further.
TEST(FootprintSetup, MajorAxisTurnsMost) {
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(60, random));
    packet.n = NormalsWithin(0.5, random);
    FootprintCase c;
    if (!c.Make(packet, SetupOf(FootprintForm::kSeamless, FootprintPattern::kTwo))) continue;
    const ideal::Footprint field(c.frame, packet);
    const std::array<Vector, 2> slope = Slopes(field);
    const Vector up = ideal::Normalised(
        ideal::Sum(ideal::ToReal(packet.n[0]),
                   ideal::Sum(ideal::ToReal(packet.n[1]), ideal::ToReal(packet.n[2]))));
    const auto turn = [&](const Vector& by) {
      return std::sqrt(std::max(0.0, ideal::Dot(by, by) - std::pow(ideal::Dot(by, up), 2)));
    };
    double most = 0;
    for (int step = 0; step < 360; ++step) {
      const double angle = step * std::acos(-1) / 360;
      most = std::max(most, turn(ideal::Sum(ideal::Scaled(std::cos(angle), slope[0]),
                                            ideal::Scaled(std::sin(angle), slope[1]))));
    }
    EXPECT_NEAR(turn(c.Offset(0)), kRadius / 2 * most, 1e-4 * most + 1e-7);
  }
}

// With 1 / distance as weights, the interpolation on the surface.
TEST(FootprintSetup, PerspectiveWeights) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(1, 3);
  for (int i = 0; i < 2000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(80, random));
    packet.n = NormalsWithin(0.6, random);
    const std::array<double, 3> distance = {uniform(random), uniform(random), uniform(random)};
    const double nearest = *std::min_element(distance.begin(), distance.end());
    VertexWeights weights;
    for (size_t v = 0; v < 3; ++v) weights[v] = std::llround((1 << 22) * nearest / distance[v]);
    FootprintCase c;
    if (!c.Make(packet, SetupOf(FootprintForm::kSeamless, FootprintPattern::kEight), weights))
      continue;
    const ideal::Footprint field(c.frame, packet, distance);
    TrianglePacket folded = packet;
    folded.n = c.result.vertex;
    const ideal::Footprint unit(c.frame, folded);
    EXPECT_LT(AngleBetween(unit.Normal(250, 260), field.Normal(250, 260)), 1e-5);
    EXPECT_LT(MomentError(c, Slopes(unit), FootprintPattern::kEight),
              FootprintSetup::kContract.max_error_ulp);
  }
}

TEST(FootprintSetup, EqualNormalsCostOneSample) {
  std::mt19937 random(6);
  for (const auto form : {FootprintForm::kSeamless, FootprintForm::kPaper}) {
    FootprintSetup::Options options;
    options.form = form;
    TrianglePacket packet = PacketAt(RandomCorners(40, random));
    packet.n = NormalsWithin(0, random);
    FootprintCase c;
    c.frame.materials[0].specular = {Reflectance::FromRaw(1), Reflectance(), Reflectance()};
    c.frame.materials[0].shininess = Shininess::FromRaw(256 << Shininess::kFraction);
    ASSERT_TRUE(c.Make(packet, FootprintSetup(options)));
    EXPECT_EQ(c.result.footprint.pattern, FootprintPattern::kCentre);
    EXPECT_FALSE(c.result.subdivide);
    packet.n[1] = Near(packet.n[1], 0.5, random);
    ASSERT_TRUE(c.Make(packet, FootprintSetup(options)));
    EXPECT_NE(c.result.footprint.pattern, FootprintPattern::kCentre);
    c.frame.materials[0].specular = {};  // no highlight: the shininess does not matter
    ASSERT_TRUE(c.Make(packet, FootprintSetup(options)));
    EXPECT_EQ(c.result.footprint.pattern, FootprintPattern::kCentre);
  }
}

// However thin a triangle: samples stay within the formats, half a barycentric around the centre.
TEST(FootprintSetup, SliversHaveShortReach) {
  std::mt19937 random(7);
  CornerGenerator corners(8, 512, 512);
  int limited = 0;
  for (int i = 0; i < 50000; ++i) {
    TrianglePacket packet = PacketOf(corners.Any());
    packet.n = AnyNormals(&corners, random);
    for (const auto form : {FootprintForm::kSeamless, FootprintForm::kPaper}) {
      FootprintCase c;
      if (!c.Make(packet, SetupOf(form, FootprintPattern::kEight))) continue;
      for (size_t k = 0; k < 3; ++k) {
        const Vector o = c.Offset(k);
        for (const double component : o) {
          if (form == FootprintForm::kSeamless) {
            EXPECT_LE(std::abs(component), 1.002);
          }
          limited += std::abs(component) > 0.5;
        }
        for (const Margin m : c.result.footprint.offset[k].margin) {
          EXPECT_LT(std::abs(m.ToReal()), 4);
        }
      }
    }
  }
  EXPECT_GT(limited, 1000);
}

}  // namespace
}  // namespace shading
