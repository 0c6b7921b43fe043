// SPDX-License-Identifier: Apache-2.0
#include "model/normal/span_normals.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/normal/span_normals_checks.h"

namespace shading {
namespace {

TEST(SpanNormals, ModelWithinErrorBound) {
  std::mt19937 random(1);
  WorstEnds worst;
  for (const int height : {4096, 480, 3}) {
    const FrameState frame = SpanFrame(height == 3 ? 4096 : 640, height);
    CornerGenerator corners(static_cast<uint32_t>(height), frame.width, frame.height);
    Attached t;
    for (int i = 0; i < 4000; ++i) {
      if (!t.Make(AnyTriangle(&corners, random), frame, Interpolation::kSpherical)) continue;
      const ideal::Slerp ideal(frame, t.packet);
      const size_t n = t.spans.size();
      for (size_t k = 0; k < n; k += k < 2 || k + 4 > n ? size_t{1} : size_t{61}) {
        worst.Measure(t, ideal, t.spans[k]);
      }
    }
  }
  EXPECT_LE(worst.below_170, kBound);
  EXPECT_GT(worst.below_170, 0.49) << "rounding alone gives half an ulp";
  EXPECT_LE(worst.beyond, 0x1p-7);
  EXPECT_LE(worst.length, 0x1p-26);
  std::printf("below 170 deg %.4f ulp; beyond 0.5 + %.2e / |Na + Nb|; |N|^2 - 1 %.2e\n",
              worst.below_170, worst.beyond, worst.length);
}

TEST(SpanNormals, LongEdgesStayOnTheArc) {
  std::mt19937 random(2);
  CornerGenerator choice(3, 4096, 4096);
  Real worst = 0;
  for (int climb = 0; climb < 30; ++climb) {
    const Vector3 first = RandomNormal(random);
    const double spread = std::ldexp(1.0, -climb % 16);
    LongEdge best = {first, Near(first, spread, random), -choice.Integer(0, 4096 * kPixel),
                     4096 * kPixel + choice.Integer(0, 4095 * kPixel)};
    Real error = best.Error();
    for (int step = 0; step < 60; ++step) {
      LongEdge next = best;
      if (step % 3 == 0) next.b = Near(best.b, spread / 8, random);
      if (step % 3 == 1) next.top = -choice.Integer(0, 4096 * kPixel);
      if (step % 3 == 2) next.bottom = 4096 * kPixel + choice.Integer(0, 4095 * kPixel);
      const Real changed = next.Error();
      if (changed > error) best = next, error = changed;
    }
    worst = std::max(worst, error);
  }
  EXPECT_LT(worst, 0x1.1p-7) << "t^2 / 2 roundings of 2^-60";
  std::printf("4096 rows: %.2e ulp of S1.30\n", static_cast<double>(worst));
}

TEST(SpanNormals, LinearWithinErrorBound) {
  std::mt19937 random(4);
  const FrameState frame = SpanFrame(4096, 4096);
  CornerGenerator corners(5, frame.width, frame.height);
  double worst = 0;
  Attached t;
  for (int i = 0; i < 5000; ++i) {
    if (!t.Make(AnyTriangle(&corners, random), frame, Interpolation::kLinear)) continue;
    EXPECT_EQ(t.splits, 0);
    ASSERT_EQ(t.spans.size(), t.whole.size());
    const ExactTriangle exact(t.packet);
    for (size_t k = 0; k < t.spans.size();
         k += k < 2 || k + 4 > t.spans.size() ? size_t{1} : size_t{61}) {
      for (const int end : {0, 1}) {
        const SpanCommand& span = t.spans[k];
        const auto weight = exact.Weights(span.x + (end ? span.length - 1 : 0), span.y);
        for (size_t c = 0; c < 3; ++c) {
          Real expected = 0;
          for (size_t v = 0; v < 3; ++v) {
            expected += static_cast<Real>(weight[v]) * static_cast<Real>(t.packet.n[v][c].raw());
          }
          expected *= 256 / static_cast<Real>(exact.area());  // S1.22 to S1.30
          const auto actual = span.normal[static_cast<size_t>(end)][c].raw();
          worst =
              std::max(worst, static_cast<double>(std::abs(expected - static_cast<Real>(actual))));
        }
      }
    }
  }
  EXPECT_LE(worst, 0.516);
  std::printf("linear %.4f ulp\n", worst);
}

TEST(SpanNormals, SplitsTileTheirSpan) {
  std::mt19937 random(6);
  const FrameState frame = SpanFrame(300, 200);
  CornerGenerator corners(7, frame.width, frame.height);
  Attached t;
  int64_t splits = 0;
  for (int i = 0; i < 6000; ++i) {
    if (!t.Make(AnyTriangle(&corners, random), frame, Interpolation::kSpherical)) continue;
    ASSERT_EQ(ExpectTiling(t), t.splits);
    splits += t.splits;
  }
  EXPECT_GT(splits, 10000);
}

TEST(SpanNormals, KeepsEarlierSpans) {
  const FrameState frame = SpanFrame(64, 64);
  std::mt19937 random(8);
  CornerGenerator corners(9, 64, 64);
  Attached t;
  while (!t.Make(AnyTriangle(&corners, random), frame, Interpolation::kSpherical) || !t.splits) {
  }
  std::vector<SpanCommand> spans = {{1, 2, 3, DepthAcc(), true}};
  spans.insert(spans.end(), t.whole.begin(), t.whole.end());
  EXPECT_EQ(
      SpanNormals::Attach(t.geometry, t.packet, Interpolation::kSpherical, 1, t.dz_dx, &spans),
      t.splits);
  ASSERT_EQ(spans.size(), t.spans.size() + 1);
  EXPECT_EQ(spans[0].x, 1);
  EXPECT_EQ(spans[0].normal, SpanCommand().normal);
  for (size_t i = 0; i < t.spans.size(); ++i) EXPECT_EQ(spans[i + 1].normal, t.spans[i].normal);
  EXPECT_EQ(SpanNormals::Attach(t.geometry, t.packet, Interpolation::kSpherical, spans.size(),
                                t.dz_dx, &spans),
            0);
}

// A rectangle of 100 x 5 pixels, cut along its diagonal.
TrianglePacket Upper(const Vector3& left, const Vector3& right, const Vector3& below) {
  TrianglePacket packet =
      PacketOf({Point{128, 128}, {128, 128 + 5 * kPixel}, {128 + 100 * kPixel, 128}});
  packet.n = {left, below, right};
  return packet;
}

TEST(SpanNormals, OpposedNormalsTurnThroughTheFixedPerpendicular) {
  const Vector3 z = Quantised(0, 0, 1), axis = Quantised(0.6, 0.6, 0.5291502622129182);
  Attached t;
  // The row through the vertices: from +z to -z through +x, at every pixel.
  ASSERT_TRUE(t.Make(Upper(z, Opposite(z), z), SpanFrame(128, 16), Interpolation::kSpherical));
  ASSERT_GE(t.spans.size(), 2u);
  EXPECT_EQ(t.spans[0].length, 50);
  EXPECT_EQ(t.spans[0].normal[0][2].raw(), int64_t{1} << 30);
  const double turned = static_cast<double>(kPi) * 50 / 100;  // pixel 50 of 0..100
  EXPECT_LE(UlpsBetween(t.spans[1].normal[0], {std::sin(turned), 0, std::cos(turned)}), kBound);
  // Down the left edge; the ideal has the same direction.
  const FrameState frame = SpanFrame(128, 16);
  const TrianglePacket down = Upper(axis, axis, Opposite(axis));
  ASSERT_TRUE(t.Make(down, frame, Interpolation::kSpherical));
  const ideal::Slerp ideal(frame, down);
  for (const SpanCommand& span : t.spans) {
    EXPECT_LE(UlpsBetween(span.normal[0], ideal.Normal(span.x + 0.5, span.y + 0.5)), kBound);
    EXPECT_NEAR(ideal::Dot(RealOf(span.normal[0]), RealOf(span.normal[0])), 1, 0x1p-26);
  }
}

TEST(SpanNormals, TwoPixelsSplitIntoOneAndOne) {
  TrianglePacket packet = PacketOf({Point{0, 0}, {0, 2 * kPixel}, {3 * kPixel, 0}});
  packet.n = {Quantised(1, 0, 0.01), Quantised(1, 0, 0.01), Quantised(-1, 0, 0.01)};
  packet.z = {VertexDepth::FromRaw(1000), VertexDepth::FromRaw(2000), VertexDepth::FromRaw(9000)};
  Attached t;
  ASSERT_TRUE(t.Make(packet, SpanFrame(8, 8), Interpolation::kSpherical));
  ASSERT_EQ(t.whole[0].length, 2);
  // x_l = 0, x_r = 9/4, and the row spans 3/4 of 180 degrees.
  EXPECT_EQ(t.splits, 0) << "60 degrees apart";
  packet.x = {ScreenCoord::FromRaw(127), ScreenCoord::FromRaw(127), ScreenCoord::FromRaw(640)};
  packet.y = {ScreenCoord::FromRaw(127), ScreenCoord::FromRaw(1000), ScreenCoord::FromRaw(127)};
  packet.n[1] = packet.n[0];
  packet.x[2] = ScreenCoord::FromRaw(386);
  ASSERT_TRUE(t.Make(packet, SpanFrame(8, 8), Interpolation::kSpherical));
  ASSERT_EQ(t.whole[0].length, 2);
  ASSERT_GE(t.splits, 1);
  for (const size_t i : {size_t{0}, size_t{1}}) {
    EXPECT_EQ(t.spans[i].length, 1);
    EXPECT_EQ(t.spans[i].normal[0], t.spans[i].normal[1]);
  }
  EXPECT_EQ(ExpectTiling(t), t.splits);
}

TEST(SpanNormals, ZeroNormalsFaceTheViewer) {
  Attached t;
  ASSERT_TRUE(t.Make(Upper({}, {}, {}), SpanFrame(128, 16), Interpolation::kSpherical));
  for (const SpanCommand& span : t.spans) {
    EXPECT_EQ(span.normal[1][2].raw(), int64_t{1} << 30);
  }
}

// The normal at the left or the right end of a row; false when the row is not the triangle's.
bool OnEdge(const TrianglePacket& packet, const FrameState& frame, int row, bool left,
            ArcVector* normal) {
  TriangleGeometry geometry;
  if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return false;
  if (row < geometry.box_y || row >= geometry.box_y + geometry.rows) return false;
  *normal = RowEnds(geometry, packet).Row(row).At(left ? 0 : kArcOne);
  return true;
}

TEST(SpanNormals, NeighboursAgreeOnTheirEdge) {
  std::mt19937 random(10);
  const FrameState frame = SpanFrame(640, 480);
  CornerGenerator corners(11, frame.width, frame.height);
  int compared = 0;
  for (int i = 0; i < 20000; ++i) {
    // p above q, shared; l is left of the edge and r is right of it.
    Point p = corners.OnScreen(), q = corners.Near(p, 120 * kPixel);
    if (p.y > q.y) std::swap(p, q);
    const Point l = corners.Near(p, 90 * kPixel), r = corners.Near(q, 90 * kPixel);
    if (p.y == q.y || Cross(p, q, l) <= 0 || Cross(p, q, r) >= 0) continue;
    TrianglePacket on_left = PacketOf({p, q, l}), on_right = PacketOf({r, q, p});
    on_left.n = AnyNormals(&corners, random);
    on_right.n = {RandomNormal(random), on_left.n[1], on_left.n[0]};
    const int row = static_cast<int>(FloorDivide(p.y + corners.Integer(0, q.y - p.y), kPixel));
    if (row * kPixel + kPixel / 2 < p.y || row * kPixel + kPixel / 2 > q.y) continue;
    ArcVector a, b;
    if (!OnEdge(on_left, frame, row, false, &a) || !OnEdge(on_right, frame, row, true, &b))
      continue;
    ++compared;
    for (size_t c = 0; c < 3; ++c) {
      // The edge's own bits are equal; the arc of the row may turn them by its own rounding.
      ASSERT_NEAR(static_cast<double>(a[c] - b[c]), 0, std::ldexp(1, kArcFraction - 33));
    }
  }
  EXPECT_GT(compared, 2000);
}

TEST(SpanNormals, VertexOrderDoesNotMatter) {
  std::mt19937 random(12);
  const FrameState frame = SpanFrame(640, 480);
  CornerGenerator corners(13, frame.width, frame.height);
  Attached t, turned;
  for (int i = 0; i < 1000; ++i) {
    TrianglePacket packet = AnyTriangle(&corners, random);
    if (!t.Make(packet, frame, Interpolation::kSpherical)) continue;
    std::swap(packet.x[0], packet.x[2]);
    std::swap(packet.y[0], packet.y[2]);
    std::swap(packet.n[0], packet.n[2]);
    ASSERT_TRUE(turned.Make(packet, frame, Interpolation::kSpherical));
    ASSERT_EQ(t.spans.size(), turned.spans.size());
    for (size_t k = 0; k < t.spans.size(); ++k) {
      ASSERT_EQ(t.spans[k].normal, turned.spans[k].normal);
    }
  }
}

}  // namespace
}  // namespace shading
