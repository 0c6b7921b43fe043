// SPDX-License-Identifier: Apache-2.0
#include "model/raster/span_walker.h"

#include <gtest/gtest.h>

#include "tests/unit/raster/mesh_stimulus.h"

namespace shading {
namespace {

int64_t Walk(const TrianglePacket& packet, const FrameState& frame,
             std::vector<SpanCommand>* spans) {
  TriangleGeometry geometry;
  if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return 0;
  return SpanWalker::Walk(geometry, TriangleSetup::DepthPlane(geometry, packet), spans);
}

// How often each pixel of the screen was covered.
class Coverage {
 public:
  explicit Coverage(const FrameState& frame)
      : width_(frame.width), count_(static_cast<size_t>(frame.width * frame.height)) {}

  void Add(const std::vector<SpanCommand>& spans) {
    for (const SpanCommand& span : spans) {
      for (int i = 0; i < span.length; ++i) ++At(span.x + i, span.y);
    }
  }
  int& At(int x, int y) { return count_.at(static_cast<size_t>(y * width_ + x)); }
  int64_t Other(int expected) const {
    return static_cast<int64_t>(count_.size()) - std::count(count_.begin(), count_.end(), expected);
  }

 private:
  int width_;
  std::vector<int> count_;
};

void ExpectCoveredOnce(const std::vector<Corners>& clockwise, FrameState frame) {
  Coverage front(frame), back(frame), culled(frame);
  for (const Corners& corner : clockwise) {
    std::vector<SpanCommand> front_spans, back_spans, no_spans;
    frame.cull = Cull::kBack;
    Walk(PacketOf({corner[0], corner[2], corner[1]}), frame, &front_spans);
    Walk(PacketOf(corner), frame, &no_spans);
    frame.cull = Cull::kNone;
    Walk(PacketOf(corner), frame, &back_spans);
    front.Add(front_spans);
    back.Add(back_spans);
    culled.Add(no_spans);
  }
  EXPECT_EQ(front.Other(1), 0);
  EXPECT_EQ(back.Other(1), 0);
  EXPECT_EQ(culled.Other(0), 0);
}

TEST(SpanWalker, MeshCoversEveryPixelExactlyOnce) {
  for (uint32_t seed = 0; seed < 60; ++seed) {
    const FrameState frame = Screen(seed % 4 ? 97 : 640, seed % 3 ? 61 : 300);
    CornerGenerator random(seed, frame.width, frame.height);
    const int64_t margin = seed % 5 ? 700 : 7000 * kPixel;
    const Mesh mesh = RandomMesh(&random, {-random.Integer(0, margin), -random.Integer(0, margin)},
                                 {frame.width * kPixel + random.Integer(0, margin),
                                  frame.height * kPixel + random.Integer(0, margin)},
                                 500);
    std::vector<Corners> triangles;
    for (size_t t = 0; t < mesh.size(); ++t) triangles.push_back(mesh.At(t));
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    ExpectCoveredOnce(triangles, frame);
  }
}

// Point at distance t along the border of the guard band, clockwise.
Point OnBorder(int64_t t) {
  constexpr int64_t kSide = 2 * kGuardBand;
  const int64_t along = t % kSide - kGuardBand;
  switch (t / kSide) {
    case 0: return {along, -kGuardBand};
    case 1: return {kGuardBand, along};
    case 2: return {-along, kGuardBand};
    default: return {-kGuardBand, -along};
  }
}

TEST(SpanWalker, FanOfSliversCoversEveryPixelExactlyOnce) {
  const FrameState frame = Screen(300, 200);
  for (const Point hub : {Point{150 * kPixel + 128, 100 * kPixel + 128}, Point{0, 0},
                          Point{12345, 23456}, Point{128, 50 * kPixel + 128}}) {
    CornerGenerator random(static_cast<uint32_t>(hub.x), 300, 200);
    std::vector<int64_t> border;
    for (int64_t side = 0; side < 4; ++side) border.push_back(side * 2 * kGuardBand);
    for (int i = 0; i < 8000; ++i) border.push_back(random.Integer(0, 8 * kGuardBand - 1));
    // The four directions along rows and columns of centres.
    for (int64_t side = 0; side < 4; ++side) {
      border.push_back(side * 2 * kGuardBand + kGuardBand +
                       (side % 2 ? hub.y : hub.x) * (side < 2 ? 1 : -1));
    }
    std::sort(border.begin(), border.end());
    border.erase(std::unique(border.begin(), border.end()), border.end());
    std::vector<Corners> triangles;
    for (size_t i = 0; i < border.size(); ++i) {
      triangles.push_back({hub, OnBorder(border[i]), OnBorder(border[(i + 1) % border.size()])});
    }
    SCOPED_TRACE(testing::Message() << "hub " << hub.x << ' ' << hub.y);
    ExpectCoveredOnce(triangles, frame);
  }
}

// Every pixel of the screen against the definition; spans in order, on the screen, `last` once.
void ExpectExact(const TrianglePacket& packet, const FrameState& frame) {
  std::vector<SpanCommand> spans;
  const int64_t pixels = Walk(packet, frame, &spans);
  Coverage coverage(frame);
  coverage.Add(spans);
  const ExactTriangle exact(packet);
  int64_t expected = 0, wrong = 0;
  for (int y = 0; y < frame.height; ++y) {
    for (int x = 0; x < frame.width; ++x) {
      const bool covers = exact.area() != 0 && exact.Covers(x, y);
      expected += covers;
      wrong += coverage.At(x, y) != static_cast<int>(covers);
    }
  }
  ASSERT_EQ(wrong, 0);
  ASSERT_EQ(pixels, expected);
  for (size_t i = 0; i < spans.size(); ++i) {
    ASSERT_GE(spans[i].length, 1);
    ASSERT_GE(spans[i].x, 0);
    ASSERT_LE(spans[i].x + spans[i].length, frame.width);
    ASSERT_EQ(spans[i].last, i + 1 == spans.size());
    ASSERT_TRUE(i == 0 || spans[i].y > spans[i - 1].y);
  }
}

TEST(SpanWalker, CoverageEqualsDefinition) {
  constexpr std::array<std::array<int, 2>, 6> kScreens = {
      {{33, 27}, {64, 5}, {4096, 3}, {3, 4096}, {1, 300}, {1, 1}}};
  for (uint32_t i = 0; i < kScreens.size(); ++i) {
    const FrameState frame = Screen(kScreens[i][0], kScreens[i][1]);
    CornerGenerator random(i, frame.width, frame.height);
    for (int n = 0; n < 2000; ++n) ExpectExact(PacketOf(random.Any()), frame);
  }
}

// A pixel row that an edge passes at the least distance: the remainder is then 0 or d - 1.
TEST(SpanWalker, CentresNearestToEdges) {
  const FrameState frame = Screen(40, 40);
  CornerGenerator random(8, 40, 40);
  for (int n = 0; n < 3000; ++n) {
    const int64_t run = random.Integer(-8000, 8000), rise = random.Integer(300, 8000);
    const int64_t w = random.Integer(-1, 1);
    // The centre's offset from the edge's upper end: run y - rise x = w.
    int64_t y = random.Integer(0, rise - 1);
    for (int64_t tries = 0; tries < rise && (run * y - w) % rise != 0; ++tries) y = (y + 1) % rise;
    const Point centre = {random.Integer(5, 35) * kPixel + 128,
                          random.Integer(20, 39) * kPixel + 128};
    const Point upper = {centre.x - (run * y - w) / rise, centre.y - y};
    const Point lower = {upper.x + run, upper.y + rise};
    ExpectExact(PacketOf({upper, lower, Point{upper.x + 9000, centre.y}}), frame);
    ExpectExact(PacketOf({upper, lower, Point{upper.x - 9000, centre.y}}), frame);
  }
}

TEST(SpanWalker, HugeTriangleFillsWidestScreen) {
  const FrameState frame = Screen(4096, 4096);
  std::vector<SpanCommand> spans;
  const TrianglePacket packet =
      PacketOf({Point{-kGuardBand, -kGuardBand}, Point{kGuardBand, -kGuardBand},
                Point{8 * kPixel, kGuardBand}});
  EXPECT_GT(Walk(packet, frame, &spans), 4096 * 2048);
  ASSERT_EQ(spans.size(), 4096u);
  const ExactTriangle exact(packet);
  for (const SpanCommand& span : spans) {
    const int end = span.x + span.length - 1;
    ASSERT_TRUE(exact.Covers(span.x, span.y) && exact.Covers(end, span.y));
    ASSERT_TRUE(span.x == 0 || !exact.Covers(span.x - 1, span.y));
    ASSERT_TRUE(end == 4095 || !exact.Covers(end + 1, span.y));
  }
  EXPECT_EQ(spans.front().length, 4096);
}

TEST(SpanWalker, SquareOnCentresKeepsTopAndLeft) {
  const FrameState frame = Screen(8, 8);
  const int64_t low = 2 * kPixel + 128, high = 5 * kPixel + 128;
  std::vector<SpanCommand> spans;
  EXPECT_EQ(Walk(PacketOf({Point{low, low}, {high, low}, {low, high}}), frame, &spans), 6);
  EXPECT_EQ(Walk(PacketOf({Point{high, high}, {low, high}, {high, low}}), frame, &spans), 3);
  Coverage coverage(frame);
  coverage.Add(spans);
  for (int y = 0; y < 8; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(coverage.At(x, y), x >= 2 && x < 5 && y >= 2 && y < 5) << x << ' ' << y;
    }
  }
}

TEST(SpanWalker, SpansStartWithDepthOfTheirPixel) {
  CornerGenerator random(7, 320, 240);
  for (int n = 0; n < 2000; ++n) {
    TrianglePacket packet = PacketOf(random.Any());
    for (VertexDepth& z : packet.z) z = VertexDepth::FromRaw(random.Integer(0, Depth::kMaxRaw));
    TriangleGeometry geometry;
    if (TriangleSetup::Setup(packet, Screen(320, 240), &geometry) != Verdict::kDraw) continue;
    const Plane depth = TriangleSetup::DepthPlane(geometry, packet);
    std::vector<SpanCommand> spans;
    SpanWalker::Walk(geometry, depth, &spans);
    for (const SpanCommand& span : spans) {
      const uint64_t z = depth.At(span.x - geometry.box_x, span.y - geometry.box_y);
      ASSERT_EQ(span.z.raw(), static_cast<int64_t>(z)) << "S1.38 holds every covered depth";
    }
  }
}

TEST(SpanWalker, TriangleBetweenCentresAddsNothing) {
  std::vector<SpanCommand> spans = {{3, 4, 5, {}, false}};
  // The bounding box holds centre (10, 10), the triangle does not.
  const int64_t edge = 10 * kPixel;
  const TrianglePacket packet =
      PacketOf({Point{edge, edge}, {edge + 140, edge}, {edge, edge + 90}});
  TriangleGeometry geometry;
  ASSERT_EQ(TriangleSetup::Setup(packet, Screen(64, 64), &geometry), Verdict::kEmpty);
  const TrianglePacket wider =
      PacketOf({Point{edge, edge}, {edge + 140, edge}, {edge, edge + 130}});
  ASSERT_EQ(TriangleSetup::Setup(wider, Screen(64, 64), &geometry), Verdict::kDraw);
  EXPECT_EQ(SpanWalker::Walk(geometry, {}, &spans), 0);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].length, 5);
  EXPECT_FALSE(spans[0].last) << "its mark is not for this triangle to set";
}

}  // namespace
}  // namespace shading
