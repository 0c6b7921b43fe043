// SPDX-License-Identifier: Apache-2.0
#include "model/raster/subdivision.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "model/raster/front_end.h"
#include "tb/stimulus/random_triangles.h"
#include "tests/unit/raster/packet_stimulus.h"

namespace shading {
namespace {

constexpr double kPi = 3.14159265358979323846;

Vector3 Unit(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  return {NormalComponent::Round(x / length), NormalComponent::Round(y / length),
          NormalComponent::Round(z / length)};
}

int64_t LimitOf(double degrees) {
  const double chord = 2 * std::sin(degrees * kPi / 360);
  return static_cast<int64_t>(std::ldexp(chord * chord, 44));
}

// A right angle of 4096 units whose normals lean apart by some `turn`.
TrianglePacket Leaning(double turn) {
  TrianglePacket packet = PacketOf({Point{0, 0}, {0, 4096}, {4096, 0}});
  packet.n = {Unit(-turn, turn, 1), Unit(-turn, -turn, 1), Unit(turn, turn, 1)};
  return packet;
}

Int128 DoubledArea(const TrianglePacket& p) {
  return Cross({p.x[0].raw(), p.y[0].raw()}, {p.x[1].raw(), p.y[1].raw()},
               {p.x[2].raw(), p.y[2].raw()});
}

TEST(Subdivision, FlatTrianglePasses) {
  const TrianglePacket packet = Leaning(0.01);
  const Subdivision subdivision(LimitOf(10));
  EXPECT_FALSE(subdivision.TurnsTooFar(packet));
  std::vector<TrianglePacket> pieces;
  subdivision.Split(packet, &pieces);
  ASSERT_EQ(pieces.size(), 1u);
  EXPECT_EQ(pieces[0].n, packet.n);
  EXPECT_EQ(pieces[0].x, packet.x);
}

// No edge of a piece is over the limit, and the pieces fill the triangle: no overlap, no hole.
TEST(Subdivision, PiecesAreWithinTheLimitAndFillTheTriangle) {
  for (const double turn : {0.1, 0.3, 0.6, 1.5}) {
    const TrianglePacket packet = Leaning(turn);
    const Subdivision subdivision(LimitOf(10));
    ASSERT_TRUE(subdivision.TurnsTooFar(packet));
    std::vector<TrianglePacket> pieces;
    subdivision.Split(packet, &pieces);
    Int128 area = 0;
    for (const TrianglePacket& piece : pieces) {
      EXPECT_FALSE(subdivision.TurnsTooFar(piece)) << "turn " << turn;
      EXPECT_EQ(DoubledArea(piece) > 0, DoubledArea(packet) > 0) << "orientation";
      area += DoubledArea(piece);
    }
    EXPECT_TRUE(area == DoubledArea(packet)) << "turn " << turn;
    EXPECT_GT(pieces.size(), 1u);
  }
}

// The middle of a halved edge against real arithmetic.
TEST(Subdivision, ModelWithinErrorBound) {
  std::mt19937 random(1);
  std::normal_distribution<double> gauss;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    TrianglePacket packet = PacketOf({Point{0, 0}, {0, 4001}, {4096, 0}});
    for (Vector3& n : packet.n) n = Unit(gauss(random), gauss(random), gauss(random));
    // The first edge is just over the limit.
    int64_t turn = 0;
    for (size_t c = 0; c < 3; ++c) {
      const int64_t difference = packet.n[0][c].raw() - packet.n[1][c].raw();
      turn += difference * difference;
    }
    std::vector<TrianglePacket> pieces;
    Subdivision(turn - 1).Split(packet, &pieces);
    std::map<std::pair<int64_t, int64_t>, Vector3> normals;
    for (const TrianglePacket& piece : pieces) {
      for (size_t k = 0; k < 3; ++k) normals[{piece.x[k].raw(), piece.y[k].raw()}] = piece.n[k];
    }
    const auto& a = packet.n[0];
    const auto& b = packet.n[1];
    double sum[3], length = 0;
    for (size_t c = 0; c < 3; ++c) {
      sum[c] = a[c].ToReal() + b[c].ToReal();
      length += sum[c] * sum[c];
    }
    if (length < 1.0 / 1024) continue;
    const Vector3 middle = normals.at({0, 2000});
    for (size_t c = 0; c < 3; ++c) {
      worst = std::max(worst, std::abs(std::ldexp(sum[c] / std::sqrt(length), 22) -
                                       static_cast<double>(middle[c].raw())));
    }
  }
  EXPECT_LE(worst, Subdivision::kContract.max_error_ulp + 1e-6);
  EXPECT_GT(worst, 0.49) << "the search is blind";
}

// Two triangles that share an edge cut it at the same points: every vertex on it is a vertex of
// both.
TEST(Subdivision, NeighboursShareTheirVertices) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> lean(-1, 1);
  for (int i = 0; i < 500; ++i) {
    TrianglePacket left = PacketOf({Point{0, 0}, {0, 4096}, {4096, 0}});
    TrianglePacket right = PacketOf({Point{4096, 0}, {0, 4096}, {5000, 5000}});
    for (Vector3& n : left.n) n = Unit(lean(random), lean(random), 1);
    right.n = {left.n[2], left.n[1], Unit(lean(random), lean(random), 1)};
    const Subdivision subdivision(LimitOf(7));
    std::map<int64_t, Vector3> on_edge[2];
    for (const int side : {0, 1}) {
      std::vector<TrianglePacket> pieces;
      subdivision.Split(side == 0 ? left : right, &pieces);
      for (const TrianglePacket& piece : pieces) {
        for (size_t k = 0; k < 3; ++k) {
          if (piece.x[k].raw() + piece.y[k].raw() == 4096)
            on_edge[side][piece.x[k].raw()] = piece.n[k];
        }
      }
    }
    ASSERT_EQ(on_edge[0], on_edge[1]) << "pair " << i;
  }
}

TEST(Subdivision, OpposedNormalsAndTinyEdgesEnd) {
  TrianglePacket packet = PacketOf({Point{0, 0}, {0, 4096}, {4096, 0}});
  packet.n = {Unit(0, 0, 1), Unit(0, 0, -1), Unit(0, 0, 1)};
  std::vector<TrianglePacket> pieces;
  Subdivision(LimitOf(1)).Split(packet, &pieces);
  EXPECT_EQ(pieces.size(), 1u);
  pieces.clear();
  TrianglePacket tiny = PacketOf({Point{0, 0}, {0, 1}, {1, 0}});
  tiny.n = Leaning(1).n;
  Subdivision(LimitOf(1)).Split(tiny, &pieces);
  EXPECT_EQ(pieces.size(), 1u);
}

TEST(Subdivision, MethodsWithoutALimitNeverSplit) {
  const TriangleList list = tb::RandomTriangles(5, 400);
  const FrontEndOptions options{Tolerance::FromRaw(0), Subdivide::kSplit};
  for (const Method method : {Method::kFlat, Method::kPhong, Method::kSlerp}) {
    EXPECT_EQ(FrontEnd::Run(list, method, options).over_limit, 0) << Name(method);
  }
}

// Through the front end: counted, and the pixels of the whole triangles are covered.
TEST(Subdivision, FrontEndCountsAndSplits) {
  const TriangleList list = tb::RandomTriangles(5, 400);
  FrontEndOptions options;
  const FrameWork whole = FrontEnd::Run(list, Method::kQuad, options);
  options.subdivide = Subdivide::kReport;
  const FrameWork reported = FrontEnd::Run(list, Method::kQuad, options);
  options.subdivide = Subdivide::kSplit;
  const FrameWork split = FrontEnd::Run(list, Method::kQuad, options);
  EXPECT_EQ(whole.over_limit, 0);
  EXPECT_GT(reported.over_limit, 0);
  EXPECT_EQ(reported.pieces, 0);
  EXPECT_EQ(reported.pixels, whole.pixels);
  EXPECT_EQ(split.over_limit, reported.over_limit);
  EXPECT_GT(split.pieces, split.over_limit);
  const auto packets = static_cast<int64_t>(list.triangles.size());
  for (const FrameWork* work : {&whole, &reported}) {
    EXPECT_EQ(static_cast<int64_t>(work->triangles.size()) + work->skipped.total(), packets);
  }
  const auto split_triangles = static_cast<int64_t>(split.triangles.size());
  const int64_t whole_triangles = split_triangles - split.pieces;
  EXPECT_LE(whole_triangles + split.skipped.total(), packets);
  EXPECT_GE(whole_triangles + split.skipped.total() + split.over_limit, packets);
  // A packet is skipped once, not once a piece.
  EXPECT_LE(split.skipped.total() - whole.skipped.total(), split.over_limit);
  EXPECT_NEAR(static_cast<double>(split.pixels), static_cast<double>(whole.pixels),
              0.02 * static_cast<double>(whole.pixels));
}

}  // namespace
}  // namespace shading
