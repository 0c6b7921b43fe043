// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/footprint_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "model/footprint/aniso_footprint.h"
#include "tests/unit/footprint/footprint_stimulus.h"

namespace shading {
namespace {

using ideal::Vector;
constexpr double kRadius = ideal::Footprint::kRadius;

struct Case {
  FrameState frame = SpanFrame(512, 512);
  TrianglePacket packet;
  TriangleGeometry geometry;
  FootprintSetup::Result result;

  bool Make(const TrianglePacket& triangle, const FootprintSetup& setup,
            const VertexWeights& weights = kNoPerspective) {
    packet = triangle;
    if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return false;
    result = setup.Of(packet, geometry, frame.materials[0], geometry.box_x, geometry.box_y, weights);
    return true;
  }
  Vector Offset(size_t k) const {
    const auto& normal = result.footprint.offset[k].normal;
    return {normal[0].ToReal(), normal[1].ToReal(), normal[2].ToReal()};
  }
};

Vector Difference(const Vector& a, const Vector& b) { return ideal::Sum(a, ideal::Scaled(-1, b)); }

// d(normal)/dx and d(normal)/dy, from the values one pixel apart.
template <typename Normal>
std::array<Vector, 2> Slopes(const Normal& field) {
  const Vector centre = field.Normal(256, 256);
  return {Difference(field.Normal(257, 256), centre), Difference(field.Normal(256, 257), centre)};
}

// A disc that spans half a barycentric at most.
double RadiusOf(const TrianglePacket& packet) {
  std::array<double, 3> x, y;
  double longest = 0;
  for (size_t i = 0; i < 3; ++i) x[i] = packet.x[i].ToReal(), y[i] = packet.y[i].ToReal();
  for (size_t i = 0; i < 3; ++i) {
    longest = std::max(longest, std::hypot(x[(i + 1) % 3] - x[i], y[(i + 1) % 3] - y[i]));
  }
  const double area =
      std::abs((x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]));
  return std::min(kRadius, area / longest / 2);
}

// The normals' second moments over a disc, sum of offset offset' by weight, are those of the samples,
// whatever axes were chosen. In ulp of S1.28 for the offset itself.
double MomentError(const Case& c, const std::array<Vector, 2>& slope, FootprintPattern pattern) {
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
      Case c;
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
    Case c;
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

double AngleBetween(const Vector& a, const Vector& b) {
  const Vector u = ideal::Normalised(a), v = ideal::Normalised(b);
  const Vector gap = Difference(u, v);
  return std::sqrt(ideal::Dot(gap, gap));
}

// The folded vertices give the enlarged triangle's own interpolation, the margins its inside.
TEST(FootprintSetup, PaperFormIsTheEnlargedTriangle) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> anywhere(150, 360);
  int inside = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(50, random));
    packet.n = NormalsWithin(0.6, random);
    Case c;
    if (!c.Make(packet, SetupOf(FootprintForm::kPaper, FootprintPattern::kCentre))) continue;
    TrianglePacket folded = packet;
    folded.n = c.result.vertex;
    const ideal::PaperFootprint paper(c.frame, packet);
    const ideal::Footprint field(c.frame, folded);
    EXPECT_EQ(c.result.subdivide, paper.Subdivides());
    for (int point = 0; point < 20; ++point) {
      const int x = anywhere(random), y = anywhere(random);
      const Margins margin = c.result.At(x - c.geometry.box_x, y - c.geometry.box_y);
      const auto weight = paper.Weights(x + 0.5, y + 0.5);
      for (size_t k = 0; k < 3; ++k) {
        const double expected = weight[k] * 7 / 8;
        if (std::abs(expected) > 7) continue;  // wraps beyond 8
        EXPECT_NEAR(margin[k].ToReal(), expected, 1e-8);
      }
      if (paper.Outside(x + 0.5, y + 0.5)) {
        ++outside;
        continue;
      }
      ++inside;
      const Vector expected = paper.Normal(x + 0.5, y + 0.5);
      EXPECT_LT(AngleBetween(field.Normal(x + 0.5, y + 0.5), expected) *
                    std::sqrt(ideal::Dot(expected, expected)), 2e-6);
    }
  }
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 5000);
}

// Which samples are outside, against the unsigned areas of (3).
TEST(FootprintSetup, PaperFormExcludesWhatIsOutside) {
  std::mt19937 random(4);
  int excluded = 0, samples = 0;
  for (int i = 0; i < 40000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(0.3 + 0.2 * (i % 8), random));
    packet.n = NormalsWithin(0.3, random);
    Case c;
    if (!c.Make(packet, SetupOf(FootprintForm::kPaper, FootprintPattern::kFour))) continue;
    const ideal::PaperFootprint paper(c.frame, packet);
    const std::array<Vector, 2> slope = Slopes(paper);
    const ideal::Barycentric inside(packet);
    for (int y = c.geometry.box_y; y < c.geometry.box_y + c.geometry.rows; ++y) {
      for (int x = c.geometry.box_x; x < c.geometry.box_x + c.geometry.columns; ++x) {
        const auto weight = inside.AtPixel(x, y);
        if (*std::min_element(weight.begin(), weight.end()) < 0) continue;
        AnisoFootprint model(c.result.footprint,
                             c.result.At(x - c.geometry.box_x, y - c.geometry.box_y), 0, 1);
        int live = 0;
        for (int s = 0; s < 4; ++s) {
          const FootprintSample sample = model.Next(s, {});
          live += sample.live;
          if (s == 3 && live == 1 && sample.live) break;  // the centre in its place, or one of four
          // Where the sample lies: solve offset = slope (dx, dy) by least squares.
          const Vector o = ideal::Scaled(8.0 / 7, c.Offset(static_cast<size_t>(s / 2)));
          const double a = ideal::Dot(slope[0], slope[0]), b = ideal::Dot(slope[0], slope[1]),
                       d = ideal::Dot(slope[1], slope[1]), det = a * d - b * b;
          if (det < 1e-6) break;
          const double sign = s % 2 ? -1 : 1, p = ideal::Dot(slope[0], o), q = ideal::Dot(slope[1], o);
          const double dx = sign * (d * p - b * q) / det, dy = sign * (a * q - b * p) / det;
          const auto c1 = paper.Weights(x + 0.5 + dx, y + 0.5 + dy);
          const double nearest = *std::min_element(c1.begin(), c1.end());
          if (std::abs(nearest) < 1e-3) continue;  // on the border
          ++samples;
          excluded += !sample.live;
          ASSERT_EQ(sample.live, nearest > 0) << "sample " << s << ", nearest " << nearest;
        }
      }
    }
  }
  EXPECT_GT(excluded, 300);
  EXPECT_GT(samples, 3 * excluded);
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
    Case c;
    if (!c.Make(packet, SetupOf(FootprintForm::kSeamless, FootprintPattern::kEight), weights)) continue;
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
    Case c;
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
      Case c;
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
