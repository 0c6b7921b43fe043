// SPDX-License-Identifier: Apache-2.0
//
// The paper's form: the enlarged triangle, folded into three vertices and the signs of three sums.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/footprint/aniso_footprint.h"
#include "tests/unit/footprint/footprint_stimulus.h"

namespace shading {
namespace {

using ideal::Vector;

// The folded vertices give the enlarged triangle's own interpolation, the margins its inside.
TEST(FootprintSetup, PaperFormIsTheEnlargedTriangle) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> anywhere(150, 360);
  int inside = 0, outside = 0;
  for (int i = 0; i < 3000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(50, random));
    packet.n = NormalsWithin(0.6, random);
    FootprintCase c;
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
                    std::sqrt(ideal::Dot(expected, expected)),
                2e-6);
    }
  }
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 5000);
}

// Counts samples of covered pixels by where they lie, and checks that those outside are excluded.
struct Exclusion {
  const FootprintCase& c;
  ideal::PaperFootprint paper{c.frame, c.packet};
  std::array<Vector, 2> slope = Slopes(paper);
  int samples = 0, excluded = 0;

  // The place of an offset on the screen: offset = slope (dx, dy) by least squares.
  std::array<double, 2> PlaceOf(const Vector& offset) const {
    const double a = ideal::Dot(slope[0], slope[0]), b = ideal::Dot(slope[0], slope[1]),
                 d = ideal::Dot(slope[1], slope[1]), det = a * d - b * b;
    const double p = ideal::Dot(slope[0], offset), q = ideal::Dot(slope[1], offset);
    return {(d * p - b * q) / det, (a * q - b * p) / det};
  }

  void Pixel(int x, int y) {
    const int column = x - c.geometry.box_x, row = y - c.geometry.box_y;
    AnisoFootprint model(c.result.footprint, c.result.At(column, row), 0, 1);
    int live = 0;
    for (int s = 0; s < 4; ++s) {
      const FootprintSample sample = model.Next(s, {});
      live += sample.live;
      if (s == 3 && live == 1 && sample.live) return;  // the centre in its place, or one of four
      // P is 7/8 of the enlarged triangle's interpolation.
      const auto [dx, dy] = PlaceOf(ideal::Scaled(8.0 / 7, c.Offset(static_cast<size_t>(s / 2))));
      const int sign = s % 2 ? -1 : 1;
      const auto weight = paper.Weights(x + 0.5 + sign * dx, y + 0.5 + sign * dy);
      const double nearest = *std::min_element(weight.begin(), weight.end());
      if (!(std::abs(nearest) > 1e-3)) continue;  // on the border, or nothing turns
      ++samples;
      excluded += !sample.live;
      ASSERT_EQ(sample.live, nearest > 0) << "sample " << s << ", nearest " << nearest;
    }
  }
};

// Against the unsigned areas of (3).
TEST(FootprintSetup, PaperFormExcludesWhatIsOutside) {
  std::mt19937 random(4);
  int excluded = 0, samples = 0;
  for (int i = 0; i < 40000; ++i) {
    TrianglePacket packet = PacketAt(RandomCorners(0.3 + 0.2 * (i % 8), random));
    packet.n = NormalsWithin(0.3, random);
    FootprintCase c;
    if (!c.Make(packet, SetupOf(FootprintForm::kPaper, FootprintPattern::kFour))) continue;
    Exclusion exclusion{c};
    const ideal::Barycentric inside(packet);
    for (int y = c.geometry.box_y; y < c.geometry.box_y + c.geometry.rows; ++y) {
      for (int x = c.geometry.box_x; x < c.geometry.box_x + c.geometry.columns; ++x) {
        const auto weight = inside.AtPixel(x, y);
        if (*std::min_element(weight.begin(), weight.end()) < 0) continue;
        ASSERT_NO_FATAL_FAILURE(exclusion.Pixel(x, y));
      }
    }
    excluded += exclusion.excluded;
    samples += exclusion.samples;
  }
  EXPECT_GT(excluded, 300);
  EXPECT_GT(samples, 3 * excluded);
}

}  // namespace
}  // namespace shading
