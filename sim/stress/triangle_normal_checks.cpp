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

}  // namespace

Check OpposedNormals(bool beyond) {
  Check check = Ends();
  if (beyond) check.bound = 1;
  check.error = [beyond](const Genes& g, int narrow) {
    return SlerpEndsError(g, narrow, true, beyond);
  };
  return check;
}

std::vector<Check> TriangleNormalChecks() { return {Ends()}; }

}  // namespace shading::stress
