// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "model/ideal/slerp.h"
#include "sim/stress/triangle_genes.h"
#include "sim/stress/vectors.h"

namespace shading::stress {
namespace {

struct Screen {
  int columns, rows;
};
constexpr int kColumns = kMaxScreen;
constexpr Screen kWide = {kMaxScreen, 32}, kTall = {64, kMaxScreen};

// Normals of a triangle: the second and third at 2^-20..180 degrees or so from the first.
const std::vector<std::string> kNear = {
    "N0, turn", "N0, height", "N1 - N0, 2^(1 - 24 g)", "its direction, turn", "its height",
    "N2 - N0, 2^(1 - 24 g)", "its direction, turn", "its height"};
std::array<Vector3, 3> NearNormals(const Genes& g, size_t first, bool opposed = false) {
  const Vector start = Direction(g[first], g[first + 1]);
  std::array<Vector3, 3> n = {Rounded<NormalComponent>(start)};
  for (size_t i = 1; i < 3; ++i) {
    Vector centre = start;
    if (opposed && i == 1) centre = {-start[0], -start[1], -start[2]};
    const size_t at = first + 3 * i - 1;
    const Vector way = Direction(g[at + 1], g[at + 2]);
    const auto size = static_cast<Real>(std::pow(2.0, 1 - 24 * g[at]));
    const Vector v = {centre[0] + size * way[0], centre[1] + size * way[1],
                      centre[2] + size * way[2]};
    n[i] = Dot(v, v) < 1e-6L ? n[0] : Rounded<NormalComponent>(Unit(v));
  }
  return n;
}

TrianglePacket TurningOf(const Genes& g, Screen screen = kWide, bool opposed = false) {
  TrianglePacket packet = CornersOf(g, screen.columns, screen.rows);
  packet.n = NearNormals(g, 7, opposed);
  return packet;
}

double SumLength(const ideal::Vector& a, const ideal::Vector& b) {
  const ideal::Vector sum = ideal::Sum(a, b);
  return std::sqrt(ideal::Dot(sum, sum));
}
// How near to opposed the normals of the triangle's edges are: the least |Na + Nb|.
constexpr double kLeastSum = 0.17431148549531633;  // 2 cos 85 degrees
double EdgesSum(const TrianglePacket& packet) {
  double least = 2;
  for (size_t i = 0; i < 3; ++i) {
    const auto a = ideal::Normalised(ideal::ToReal(packet.n[i]));
    const auto b = ideal::Normalised(ideal::ToReal(packet.n[(i + 1) % 3]));
    least = std::min(least, SumLength(a, b));
  }
  return least;
}
// Of the ends of a row.
double RowSum(const ideal::Slerp& slerp, int y) {
  constexpr double kFar = 1e5;  // clamped to the ends of the row
  return SumLength(slerp.Normal(-kFar, y + 0.5), slerp.Normal(kFar, y + 0.5));
}

// Sum w_i N_i.
Vector LinearAt(const ExactWeights& exact, const TrianglePacket& packet, int x, int y) {
  Vector n = {};
  for (size_t v = 0; v < 3; ++v) {
    const Real w = static_cast<Real>(exact.At(v, x, y)) / static_cast<Real>(exact.area());
    for (size_t c = 0; c < 3; ++c) n[c] += w * packet.n[v][c].ToReal();
  }
  return n;
}

struct Attached {
  TrianglePacket packet;
  std::vector<SpanCommand> spans;
  bool Make(const Genes& g, SpanNormals::Interpolation how, Screen screen = kWide,
            bool opposed = false) {
    packet = TurningOf(g, screen, opposed);
    TriangleGeometry geometry;
    const FrameState frame = FrameOf(screen.columns, screen.rows);
    if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return false;
    if (SpanWalker::Walk(geometry, {}, &spans) == 0) return false;
    SpanNormals::Attach(geometry, packet, how, 0, {}, &spans);
    return true;
  }
  // Calls visit(span, end, x) for both ends of a few spans.
  template <typename Visit>
  void ForEnds(const Visit& visit) const {
    for (size_t k = 0; k < spans.size(); k += std::max<size_t>(1, spans.size() / 4)) {
      for (const size_t end : {size_t{0}, size_t{1}})
        visit(spans[k], end, spans[k].x + (end ? spans[k].length - 1 : 0));
    }
  }
};

double LinearEndsError(const Genes& g, int narrow) {
  Attached t;
  if (!t.Make(g, SpanNormals::Interpolation::kLinear)) return 0;
  const ExactWeights exact(t.packet);
  Real worst = 0;
  t.ForEnds([&](const SpanCommand& span, size_t end, int x) {
    Raise(&worst, Farthest(span.normal[end], LinearAt(exact, t.packet, x, span.y), narrow));
  });
  return static_cast<double>(worst);
}

// Slerp along edges and rows; `opposed`: N1 near -N0, on a tall screen; `beyond`: only beyond 170
// degrees, as a part of the 1/2 + 2^-7 / |Nl + Nr| ulp that are allowed there.
double SlerpEndsError(const Genes& g, int narrow, bool opposed, bool beyond) {
  Attached t;
  const Screen screen = opposed ? kTall : kWide;
  if (!t.Make(g, SpanNormals::Interpolation::kSpherical, screen, opposed)) return 0;
  const double edges = EdgesSum(t.packet);
  // Below 2^-22 an end may lie on either side of where opposed normals turn a fixed way.
  if (edges < (beyond ? 0x1p-20 : kLeastSum)) return 0;
  const ideal::Slerp slerp(FrameOf(screen.columns, screen.rows), t.packet);
  Real worst = 0;
  t.ForEnds([&](const SpanCommand& span, size_t end, int x) {
    const double least = std::min(edges, RowSum(slerp, span.y));
    if (beyond ? least > kLeastSum || least < 0x1p-20 : least < kLeastSum) return;
    const ideal::Vector n = slerp.Normal(x + 0.5, span.y + 0.5);
    const double off = Farthest(span.normal[end], {n[0], n[1], n[2]}, narrow);
    Raise(&worst, beyond ? off / (0.5 + 0x1p-7 / least) : off);
  });
  return static_cast<double>(worst);
}

double SpanEndsError(const Genes& g, int narrow) {
  return g[15] < 0.3 ? LinearEndsError(g, narrow) : SlerpEndsError(g, narrow, false, false);
}

Check Ends() {
  Check check = CheckOf(SpanNormals::kContract, "2^-30", "normals S1.29");
  check.genes = kCorners;
  check.genes.insert(check.genes.end(), kNear.begin(), kNear.end());
  check.genes.push_back("linear below 0.3, spherical");
  check.error = SpanEndsError;
  check.triangle = [](const Genes& g) {
    return TriangleList{FrameOf(kWide.columns, kWide.rows), {TurningOf(g)}};
  };
  check.cost = 40;
  return check;
}

Vector SumOf(const Vector3& a, const Vector3& b) {
  const Vector u = RealOf(a), v = RealOf(b);
  return {u[0] + v[0], u[1] + v[1], u[2] + v[2]};
}

// A triangle whose first edge alone turns further than the limit; vertex 2 has the mean normal.
TrianglePacket FirstEdgeTurns(const Genes& g, int64_t* limit) {
  TrianglePacket packet =
      CornersOf({0.1, g[8], g[9], g[10], g[11], g[9], g[8]}, kColumns, kColumns);
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
    return TriangleList{FrameOf(kColumns, kColumns), {FirstEdgeTurns(g, &limit)}};
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
  std::array<Vector, 2> slope = {};
  for (size_t c = 0; c < 3; ++c) {
    for (size_t v = 0; v < 3; ++v) {
      const Real n = packet.n[v][c].ToReal() / static_cast<Real>(exact.area());
      slope[0][c] += n * static_cast<Real>(exact.Dx(v));
      slope[1][c] += n * static_cast<Real>(exact.Dy(v));
    }
  }
  const Real radius = RadiusOf(exact);
  Real worst = 0, scale = 0;
  for (size_t i = 0; i < 3; ++i) {
    for (size_t j = 0; j < 3; ++j) {
      Real moment = 0;
      for (const FootprintOffset& o : offsets) {
        const auto at = [&](size_t c) {  // 37 - 9 fraction bits when narrowed: S1.28 less one
          const int drop = 11 * narrow;
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

Check OpposedNormals(bool beyond) {
  Check check = Ends();
  if (beyond) check.bound = 1;
  check.error = [beyond](const Genes& g, int narrow) {
    return SlerpEndsError(g, narrow, true, beyond);
  };
  return check;
}

std::vector<Check> TriangleNormalChecks() { return {Ends(), Middle(), Moments()}; }

}  // namespace shading::stress
