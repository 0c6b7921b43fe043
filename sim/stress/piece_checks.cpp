// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/triangle_genes.h"
#include "sim/stress/vectors.h"

namespace shading::stress {
namespace {

Vector SumOf(const Vector3& a, const Vector3& b) {
  const Vector u = RealOf(a), v = RealOf(b);
  return {u[0] + v[0], u[1] + v[1], u[2] + v[2]};
}

// A triangle whose first edge alone turns further than the limit; vertex 2 has the mean normal.
TrianglePacket FirstEdgeTurns(const Genes& g, int64_t* limit) {
  TrianglePacket packet =
      CornersOf({0.1, g[8], g[9], g[10], g[11], g[9], g[8]}, kMaxScreen, kMaxScreen);
  packet.n = NearNormals(g, 0);
  const Vector sum = SumOf(packet.n[0], packet.n[1]);
  // Opposed normals have no mean: the edge stays whole.
  packet.n[2] = Dot(sum, sum) < 1.0L / 512 ? packet.n[0] : Rounded<NormalComponent>(Unit(sum));
  for (size_t i = 0; i < 2; ++i)
    packet.z[i] = VertexDepth::FromRaw(std::llround(g[5 + i] * VertexDepth::kMaxRaw));
  int64_t square = 0;
  for (size_t c = 0; c < 3; ++c) {
    const int64_t d = packet.n[0][c].raw() - packet.n[1][c].raw();
    square += d * d;
  }
  *limit = square - 1;
  return packet;
}

// The middle of the halved edge: normal, place and depth, each in its ulp.
double MiddleError(const Genes& g, int narrow) {
  int64_t limit = 0;
  const TrianglePacket packet = FirstEdgeTurns(g, &limit);
  const Vector sum = SumOf(packet.n[0], packet.n[1]);
  if (limit < 8 || Dot(sum, sum) < 1.0L / 512) return 0;
  std::vector<TrianglePacket> pieces;
  Subdivision(limit).Split(packet, &pieces);
  if (pieces.size() != 2) return 0;
  const TrianglePacket& piece = pieces[0];
  const Vector mean = Unit(sum);
  const auto half_off = [&](int64_t middle, int64_t p, int64_t q) {
    return std::abs(static_cast<double>(2 * Narrowed(middle, narrow) - p - q) / 2);
  };
  return std::max({Farthest(piece.n[1], mean, narrow),
                   half_off(piece.x[1].raw(), packet.x[0].raw(), packet.x[1].raw()),
                   half_off(piece.y[1].raw(), packet.y[0].raw(), packet.y[1].raw()),
                   half_off(piece.z[1].raw(), packet.z[0].raw(), packet.z[1].raw())});
}

Check Middle() {
  Check check = CheckOf(Subdivision::kContract, "of each format", "S1.21, S13.7 and U0.23");
  check.genes = kNear;
  for (const char* gene : {"x0", "y0", "x1", "y1"}) check.genes.push_back(gene);
  check.error = MiddleError;
  check.triangle = [](const Genes& g) {
    int64_t limit;
    return TriangleList{FrameOf(kMaxScreen, kMaxScreen), {FirstEdgeTurns(g, &limit)}};
  };
  check.cost = 2;
  return check;
}

// Twice the area of triangles that count, in 2^-16 square pixels.
constexpr int64_t kLeastArea = 1 << 14;

// The disc's radius in pixels: 1/sqrt(3), less where that spans over half a barycentric.
Real RadiusOf(const ExactWeights& exact) {
  Real steepest = 0;
  for (size_t v = 0; v < 3; ++v) {
    const auto dx = static_cast<Real>(exact.Dx(v)), dy = static_cast<Real>(exact.Dy(v));
    steepest = std::max(steepest, std::sqrt(dx * dx + dy * dy));
  }
  return std::min(1 / std::sqrt(3.0L), static_cast<Real>(exact.area()) / steepest / 2);
}

TrianglePacket FootprintTriangle(const Genes& g) {
  TrianglePacket packet = CornersOf({0.1, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5}, 512, 512);
  double longest = 1e-3;
  for (size_t i = 0; i < 6; i += 2) {
    const size_t j = (i + 2) % 6;
    longest = std::max(longest, std::hypot(g[j] - g[i], g[j + 1] - g[i + 1]));
  }
  const double scale = Geometric(3.01, 100, g[6]) / longest;  // pixels of the longest edge
  for (size_t i = 0; i < 3; ++i) {
    packet.x[i] = ScreenCoord::Round(256 + scale * (g[2 * i] - g[0]));
    packet.y[i] = ScreenCoord::Round(256 + scale * (g[2 * i + 1] - g[1]));
  }
  packet.n = NearNormals(g, 7);
  return packet;
}

// d(normal)/dx and d(normal)/dy.
std::array<Vector, 2> SlopesOf(const TrianglePacket& packet, const ExactWeights& exact) {
  std::array<Vector, 2> slope = {};
  for (size_t c = 0; c < 3; ++c) {
    for (size_t v = 0; v < 3; ++v) {
      const Real n = packet.n[v][c].ToReal() / static_cast<Real>(exact.area());
      slope[0][c] += n * static_cast<Real>(exact.Dx(v));
      slope[1][c] += n * static_cast<Real>(exact.Dy(v));
    }
  }
  return slope;
}

// The largest |sum of offset_i offset_j by weight - r^2 / 4 (slopes)|, over the root of the largest
// expected moment: ulp of S1.28 of an offset.
double MomentError(const Genes& g, int narrow) {
  const TrianglePacket packet = FootprintTriangle(g);
  TriangleGeometry geometry;
  const FrameState frame = FrameOf(512, 512);
  if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return 0;
  const ExactWeights exact(packet);
  if (exact.area() < kLeastArea) return 0;
  FootprintSetup::Options options;
  const bool four = g[15] < 0.5;
  options.least = options.most = four ? FootprintPattern::kFour : FootprintPattern::kEight;
  const auto offsets = FootprintSetup(options)
                           .Of(packet, geometry, frame.materials[0], geometry.box_x, geometry.box_y)
                           .footprint.offset;
  const std::array<Vector, 2> slope = SlopesOf(packet, exact);
  const Real radius = RadiusOf(exact);
  Real worst = 0, scale = 0;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) {
      Real moment = 0;
      for (const FootprintOffset& o : offsets) {
        const auto at = [&](size_t c) {
          const int drop = 11 * narrow;  // from S1.38 to S1.27
          return std::ldexp(static_cast<Real>(Narrowed(o.normal[c].raw(), drop)), -38);
        };
        moment += 2 * at(i) * at(j) / (four ? 4 : 8);
      }
      const Real expected =
          radius * radius / 4 * (slope[0][i] * slope[0][j] + slope[1][i] * slope[1][j]);
      Raise(&worst, std::abs(moment - expected));
      scale = std::max(scale, std::sqrt(std::abs(expected)));
    }
  }
  return scale < 1e-9L ? 0 : static_cast<double>(std::ldexp(worst / scale, 28));
}

Check Moments() {
  Check check = CheckOf(FootprintSetup::kContract, "2^-28", "offsets S1.27");
  check.genes = kCorners;
  check.genes.erase(check.genes.begin());
  check.genes.push_back("longest edge, logarithm of 3..100 pixels");
  check.genes.insert(check.genes.end(), kNear.begin(), kNear.end());
  check.genes.push_back("four samples below 1/2, eight");
  check.error = MomentError;
  check.triangle = [](const Genes& g) {
    return TriangleList{FrameOf(512, 512), {FootprintTriangle(g)}};
  };
  check.cost = 10;
  return check;
}

}  // namespace

std::vector<Check> PieceChecks() { return {Middle(), Moments()}; }

}  // namespace shading::stress
