// SPDX-License-Identifier: Apache-2.0
#include "model/raster/triangle_setup.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/raster/span_walker.h"
#include "tests/unit/raster/packet_stimulus.h"

namespace shading {
namespace {

Verdict Judge(const Corners& corner, const FrameState& frame) {
  TriangleGeometry geometry;
  return TriangleSetup::Setup(PacketOf(corner), frame, &geometry);
}

// Corners in 1/4 pixels.
Corners Quarters(Point a, Point b, Point c) {
  Corners corner = {a, b, c};
  for (Point& p : corner) p = {p.x * kPixel / 4, p.y * kPixel / 4};
  return corner;
}

const Corners kFront = Quarters({40, 40}, {40, 200}, {200, 200});  // down, right: front
const Corners kBack = Quarters({40, 40}, {200, 200}, {40, 200});

TEST(TriangleSetup, CullsBackFaces) {
  EXPECT_EQ(Judge(kFront, Screen(64, 64, Cull::kBack)), Verdict::kDraw);
  EXPECT_EQ(Judge(kBack, Screen(64, 64, Cull::kBack)), Verdict::kBackFacing);
  EXPECT_EQ(Judge(kFront, Screen(64, 64, Cull::kNone)), Verdict::kDraw);
  EXPECT_EQ(Judge(kBack, Screen(64, 64, Cull::kNone)), Verdict::kDraw);
}

TEST(TriangleSetup, BothOrientationsGiveTheSameTriangle) {
  TriangleGeometry front, back;
  TriangleSetup::Setup(PacketOf(kFront), Screen(64, 64), &front);
  TriangleSetup::Setup(PacketOf(kBack), Screen(64, 64), &back);
  EXPECT_EQ(front.corner, (std::array<int, 3>{0, 2, 1}));
  EXPECT_EQ(back.corner, (std::array<int, 3>{0, 1, 2}));
  EXPECT_EQ(front.area, back.area);
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(front.edge[i].w0, back.edge[i].w0);
}

TEST(TriangleSetup, RejectsZeroAreaFirst) {
  for (const Cull cull : {Cull::kNone, Cull::kBack}) {
    const FrameState frame = Screen(64, 64, cull);
    EXPECT_EQ(Judge(Quarters({4, 4}, {40, 40}, {80, 80}), frame), Verdict::kDegenerate);
    EXPECT_EQ(Judge(Quarters({4, 4}, {4, 4}, {80, 80}), frame), Verdict::kDegenerate);
    EXPECT_EQ(Judge(Quarters({4, 4}, {4, 4}, {4, 4}), frame), Verdict::kDegenerate);
    EXPECT_EQ(Judge(Quarters({-9, -9}, {-9, -40}, {-9, -80}), frame), Verdict::kDegenerate);
  }
}

TEST(TriangleSetup, RejectsOffEachSide) {
  const FrameState frame = Screen(64, 32);
  const auto shifted = [&](int64_t x, int64_t y) {
    Corners corner = kFront;  // 10..50 pixels
    for (Point& p : corner) p = {p.x + x, p.y + y};
    return Judge(corner, frame);
  };
  EXPECT_EQ(shifted(-50 * kPixel - 1, 0), Verdict::kOffScreen);
  EXPECT_EQ(shifted(54 * kPixel + 1, 0), Verdict::kOffScreen);
  EXPECT_EQ(shifted(0, -50 * kPixel - 1), Verdict::kOffScreen);
  EXPECT_EQ(shifted(0, 22 * kPixel + 1), Verdict::kOffScreen);
  // Touching the border is not off the screen, though no centre lies there.
  EXPECT_EQ(shifted(-50 * kPixel, 0), Verdict::kEmpty);
  EXPECT_EQ(shifted(54 * kPixel, 0), Verdict::kEmpty);
  EXPECT_EQ(shifted(0, -50 * kPixel), Verdict::kEmpty);
  EXPECT_EQ(shifted(0, 22 * kPixel), Verdict::kEmpty);
  // The last row and column of centres is reached half a pixel further in.
  EXPECT_EQ(shifted(-50 * kPixel + 127, 0), Verdict::kEmpty);
  EXPECT_EQ(shifted(-50 * kPixel + 128, 0), Verdict::kDraw);
  EXPECT_EQ(shifted(0, 22 * kPixel - 127), Verdict::kEmpty);
  EXPECT_EQ(shifted(0, 22 * kPixel - 128), Verdict::kDraw);
}

TEST(TriangleSetup, RejectsBetweenCentres) {
  const FrameState frame = Screen(64, 64);
  EXPECT_EQ(Judge(Quarters({43, 40}, {43, 90}, {45, 90}), frame), Verdict::kEmpty);
  EXPECT_EQ(Judge(Quarters({40, 43}, {90, 43}, {90, 45}), frame), Verdict::kEmpty);
  EXPECT_EQ(Judge(Quarters({42, 40}, {42, 90}, {45, 90}), frame), Verdict::kDraw);
  // Off one axis and between the centres of the other counts as off the screen.
  EXPECT_EQ(Judge(Quarters({43, -90}, {43, -40}, {45, -40}), frame), Verdict::kOffScreen);
}

// First and last pixel whose centre lies within, one by one.
std::pair<int, int> CentresByCounting(int64_t low, int64_t high, int size) {
  int first = size, last = -1;
  for (int i = 0; i < size; ++i) {
    const int64_t centre = i * kPixel + kPixel / 2;
    if (centre < low || centre > high) continue;
    first = std::min(first, i);
    last = i;
  }
  return {first, last};
}

void ExpectDefinition(const Corners& corner, const FrameState& frame) {
  const auto [left, right] = std::minmax({corner[0].x, corner[1].x, corner[2].x});
  const auto [top, bottom] = std::minmax({corner[0].y, corner[1].y, corner[2].y});
  const auto [x0, x1] = CentresByCounting(left, right, frame.width);
  const auto [y0, y1] = CentresByCounting(top, bottom, frame.height);
  const bool off =
      right < 0 || bottom < 0 || left > frame.width * kPixel || top > frame.height * kPixel;
  const bool flat = Cross(corner[0], corner[1], corner[2]) == 0;
  const bool empty = x0 > x1 || y0 > y1;

  TriangleGeometry g;
  const TrianglePacket packet = PacketOf(corner);
  const Verdict verdict = TriangleSetup::Setup(packet, frame, &g);
  ASSERT_EQ(verdict, flat    ? Verdict::kDegenerate
                     : off   ? Verdict::kOffScreen
                     : empty ? Verdict::kEmpty
                             : Verdict::kDraw);
  if (verdict != Verdict::kDraw) return;
  ASSERT_EQ(std::make_pair(g.box_x, g.box_x + g.columns - 1), std::make_pair(x0, x1));
  ASSERT_EQ(std::make_pair(g.box_y, g.box_y + g.rows - 1), std::make_pair(y0, y1));
  const ExactTriangle exact(packet);
  ASSERT_TRUE(g.area == exact.area());
  for (size_t i = 0; i < 3; ++i) {
    const size_t v = static_cast<size_t>(g.corner[i]);
    const Edge& edge = g.edge[i];
    ASSERT_TRUE(edge.w0 == exact.Weight(v, x0, y0));
    ASSERT_TRUE(edge.w0 + edge.dx == exact.Weight(v, x0 + 1, y0));
    ASSERT_TRUE(edge.w0 + edge.dy == exact.Weight(v, x0, y0 + 1));
    ASSERT_EQ(edge.top_left, exact.Nudged(v));
  }
}

TEST(TriangleSetup, VerdictBoxAndEdgesEqualDefinition) {
  constexpr std::array<std::array<int, 2>, 5> kScreens = {
      {{1, 1}, {64, 48}, {4096, 1}, {1, 4096}, {4096, 4096}}};
  for (uint32_t i = 0; i < kScreens.size(); ++i) {
    const FrameState frame = Screen(kScreens[i][0], kScreens[i][1]);
    CornerGenerator random(i, frame.width, frame.height);
    for (int n = 0; n < 10000; ++n) ExpectDefinition(random.Any(), frame);
  }
}

// Largest errors of the planes at far covered pixels of random triangles.
struct PlaneErrors {
  double depth = 0;                // ulp of U0.24
  std::array<double, 3> weight{};  // 2^-21, by corner
  std::vector<SpanCommand> spans;

  void Try(const TrianglePacket& packet, const FrameState& frame) {
    TriangleGeometry g;
    if (TriangleSetup::Setup(packet, frame, &g) != Verdict::kDraw) return;
    const Plane depth_plane = TriangleSetup::DepthPlane(g, packet);
    spans.clear();
    if (SpanWalker::Walk(g, depth_plane, &spans) == 0) return;
    const ExactTriangle exact(packet);
    const auto planes = TriangleSetup::Barycentrics(g, spans[0].x, spans[0].y);
    ForFarPixels(spans, [&](int x, int y) {
      const auto w = exact.Weights(x, y);
      Int128 z = 0;
      for (size_t i = 0; i < 3; ++i) z += w[i] * packet.z[i].raw();
      depth = std::max(
          depth, Off(depth_plane.At(x - g.box_x, y - g.box_y) - (1 << 13), z, exact.area(), 14));
      uint64_t sum = 0;
      for (size_t i = 0; i < 3; ++i) {
        const uint64_t value = planes[i].At(x - spans[0].x, y - spans[0].y);
        sum += value;
        weight[i] =
            std::max(weight[i], 0x1p-12 * Off(value, w[static_cast<size_t>(g.corner[i])],
                                              exact.area(), TriangleSetup::kBarycentricFraction));
      }
      ASSERT_EQ(sum, uint64_t{1} << TriangleSetup::kBarycentricFraction)
          << "the weights add up to exactly 1";
    });
  }

  // |value 2^-fraction - numerator / area|, scaled by 2^14 / 2^fraction for depth, 1 for weights.
  static double Off(uint64_t value, Int128 numerator, Int128 area, int fraction) {
    const Int128 error = static_cast<int64_t>(value) * area - numerator * (Int128{1} << fraction);
    const double raw = std::abs(static_cast<double>(error) / static_cast<double>(area));
    return fraction == 14 ? raw * 0x1p-14 : raw;
  }
};

PlaneErrors Search(int size, int triangles) {
  const FrameState frame = Screen(size, size);
  CornerGenerator random(static_cast<uint32_t>(size), size, size);
  PlaneErrors errors;
  for (int n = 0; n < triangles; ++n) {
    TrianglePacket packet = PacketOf(n % 2 ? random.WholeScreen() : random.Any());
    for (VertexDepth& z : packet.z) {
      z = VertexDepth::FromRaw(random.Integer(0, 3) ? random.Integer(0, Depth::kMaxRaw)
                                                    : random.Integer(0, 1) * Depth::kMaxRaw);
    }
    errors.Try(packet, frame);
  }
  return errors;
}

TEST(TriangleSetup, PlanesWithinErrorBound) {
  const PlaneErrors worst = Search(kMaxScreen, 20000);
  RecordProperty("worst_depth_milliulp", static_cast<int>(worst.depth * 1000));
  for (size_t i = 0; i < 3; ++i) {
    RecordProperty("worst_weight_" + std::to_string(i) + "_permille_of_2^-21",
                   static_cast<int>(worst.weight[i] * 1000));
  }
  EXPECT_LE(worst.depth, TriangleSetup::kContract.max_error_ulp);
  EXPECT_LE(worst.weight[0], 1);
  EXPECT_LE(worst.weight[1], 1);
  EXPECT_LE(worst.weight[2], 2) << "one minus two rounded weights";
  EXPECT_GT(worst.depth, 0.2) << "the search is blind";
  EXPECT_GT(worst.weight[2], 1) << "the search is blind";
  EXPECT_LE(Search(1, 2000).depth, 0x1p-15);
}

}  // namespace
}  // namespace shading
