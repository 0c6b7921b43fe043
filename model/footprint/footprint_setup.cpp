// SPDX-License-Identifier: Apache-2.0
#include "model/footprint/footprint_setup.h"

#include <algorithm>

#include "model/footprint/footprint_axes.h"

namespace shading {
namespace {

using Raw = std::array<int64_t, 3>;

constexpr int kNormal = NormalComponent::kFraction;
constexpr int kEnlarged = 30;  // fraction bits of N'
constexpr int kTurn = 20;      // of squares of turns
constexpr std::array<std::array<int64_t, 3>, 3> kFold = {{{4, 2, 1}, {1, 4, 2}, {2, 1, 4}}};

Raw RawOf(const Vector3& v) { return {v[0].raw(), v[1].raw(), v[2].raw()}; }

int64_t Dot(const Raw& a, const Raw& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// 2 (from.at) at - from.
Raw Mirrored(const Raw& from, const Raw& at) {
  const int64_t dot = Dot(from, at);  // S2.44
  Raw mirrored;
  for (size_t c = 0; c < 3; ++c) {
    mirrored[c] = RoundShift(static_cast<Int128>(2 * dot) * at[c], 3 * kNormal - kEnlarged) -
                  (from[c] << (kEnlarged - kNormal));
  }
  return mirrored;
}

// Paper 001 (5).
std::array<Raw, 3> EnlargedNormals(const TrianglePacket& packet) {
  const Raw a = RawOf(packet.n[0]), b = RawOf(packet.n[1]), c = RawOf(packet.n[2]);
  return {Mirrored(c, a), Mirrored(a, b), Mirrored(b, c)};
}

bool ApartBeyondQuarter(const std::array<Raw, 3>& n) {
  const auto dot = [](const Raw& a, const Raw& b) {
    Int128 sum = 0;
    for (size_t c = 0; c < 3; ++c) sum += static_cast<Int128>(a[c]) * b[c];
    return sum;
  };
  return dot(n[0], n[1]) < 0 || dot(n[1], n[2]) < 0 || dot(n[2], n[0]) < 0;
}

NormalComponent Weighted(int64_t value, int64_t weight, int fraction) {
  constexpr int64_t kLimit = int64_t{1} << (NormalComponent::kWidth - 1);
  const int64_t rounded = RoundShift(static_cast<Int128>(value) * weight, fraction);
  return NormalComponent::FromRaw(std::clamp(rounded, -kLimit, kLimit - 1));
}

// w_i N_i, or w_i P_i with P_A = (4 N_A' + N_B' + 2 N_C') / 8.
std::array<Vector3, 3> Vertices(FootprintForm form, const TrianglePacket& packet,
                                const VertexWeights& weights, bool* subdivide) {
  std::array<Vector3, 3> vertex;
  if (form == FootprintForm::kSeamless) {
    for (size_t v = 0; v < 3; ++v) {
      for (size_t c = 0; c < 3; ++c) {
        vertex[v][c] = Weighted(packet.n[v][c].raw(), weights[v], kNormal);
      }
    }
    return vertex;
  }
  const std::array<Raw, 3> enlarged = EnlargedNormals(packet);
  *subdivide = ApartBeyondQuarter(enlarged);
  for (size_t v = 0; v < 3; ++v) {
    for (size_t c = 0; c < 3; ++c) {
      int64_t sum = 0;
      for (size_t k = 0; k < 3; ++k) sum += kFold[k][v] * enlarged[k][c];
      vertex[v][c] = Weighted(sum, weights[v], kEnlarged + 3);
    }
  }
  return vertex;
}

// Of sum value_v lambda_v, numerators over the area.
Slope SlopeOf(const std::array<Edge, 3>& edge, const std::array<Raw, 3>& value) {
  Slope slope = {};
  for (size_t v = 0; v < 3; ++v) {
    for (size_t c = 0; c < 3; ++c) {
      slope.dx[c] += value[v][c] * edge[v].dx;
      slope.dy[c] += value[v][c] * edge[v].dy;
    }
  }
  return slope;
}

// What vertex v adds to each margin: (4 a + 2 b + c) / 8 and so on, weighted, S1.22.
std::array<Raw, 3> MarginsOfVertices(const VertexWeights& weights) {
  std::array<Raw, 3> value;
  for (size_t v = 0; v < 3; ++v) {
    for (size_t k = 0; k < 3; ++k) value[v][k] = kFold[k][v] * weights[v] / 8;
  }
  return value;
}

std::array<Plane, 3> MarginPlanes(const TriangleGeometry& geometry, const std::array<Edge, 3>& edge,
                                  const std::array<Raw, 3>& value, const Slope& slope, int x,
                                  int y) {
  constexpr int64_t kScale = int64_t{1} << (FootprintSetup::kMarginPlaneFraction - kNormal);
  const int64_t column = x - geometry.box_x, row = y - geometry.box_y;
  const auto quantise = [&](Int128 sum) {
    return static_cast<uint64_t>(RoundDivide(sum * kScale, geometry.area));
  };
  std::array<Plane, 3> plane;
  for (size_t k = 0; k < 3; ++k) {
    Int128 at_origin = 0;
    for (size_t v = 0; v < 3; ++v) {
      at_origin +=
          static_cast<Int128>(value[v][k]) * (edge[v].w0 + column * edge[v].dx + row * edge[v].dy);
    }
    plane[k] = {quantise(at_origin), quantise(slope.dx[k]), quantise(slope.dy[k])};
  }
  return plane;
}

Margin RoundedMargin(uint64_t plane) {
  return Margin::Wrap(RoundShift(static_cast<int64_t>(plane),
                                 FootprintSetup::kMarginPlaneFraction - Margin::kFraction));
}

// Shininess times the square of the turn of a normal that moves by `change` (38 fraction bits) at
// the centroid: n 9 (|c|^2 |s|^2 - (c.s)^2) / |s|^4, s the sum of the vertices. 20 fraction bits,
// at most 2^10.
int64_t TurnSquare(const Raw& change, const Raw& sum, int64_t shininess) {
  constexpr int kChange = 30, kSum = kNormal - 9;  // fraction bits, so that all fits
  const Raw s = {sum[0] >> (kNormal - kSum), sum[1] >> (kNormal - kSum),
                 sum[2] >> (kNormal - kSum)};
  const Int128 length = Dot(s, s);
  if (length == 0) return 0;
  Int128 square = 0, along = 0;
  for (size_t c = 0; c < 3; ++c) {
    const Int128 by = change[c] >> (Quantity::kFraction - kChange);
    square += by * by;
    along += by * s[c];
  }
  const Int128 across = square * length - along * along;
  constexpr int kFraction = 2 * kChange + Shininess::kFraction - 2 * kSum;  // of the quotient
  const Int128 turn = (9 * shininess * across / (length * length)) >> (kFraction - kTurn);
  return static_cast<int64_t>(std::min(turn, Int128{1} << (kTurn + 10)));
}

FootprintOffset OffsetOf(const Raw& normal, const Raw& margin) {
  constexpr int64_t kLimit = int64_t{1} << (Quantity::kWidth - 1);
  FootprintOffset offset;
  for (size_t c = 0; c < 3; ++c) {
    offset.normal[c] = Quantity::FromRaw(std::clamp(normal[c], -kLimit, kLimit - 1));
    offset.margin[c] = Margin::Wrap(margin[c]);
  }
  return offset;
}

}  // namespace

VertexWeights FootprintSetup::WeightsOf(const std::array<VertexDepth, 3>& z, DepthSlope slope) {
  if (slope.raw() == 0) return kNoPerspective;
  constexpr int kFraction = VertexDepth::kFraction + DepthSlope::kFraction;
  VertexWeights inverse;  // of the distance, at least 2^-24
  for (size_t i = 0; i < 3; ++i) inverse[i] = (int64_t{1} << kFraction) - slope.raw() * z[i].raw();
  const int64_t largest = *std::max_element(inverse.begin(), inverse.end());
  for (int64_t& w : inverse) w = RoundDivide(static_cast<Int128>(w) << kNormal, largest);
  return inverse;
}

Margins FootprintSetup::Result::At(int columns, int rows) const {
  return {RoundedMargin(margin[0].At(columns, rows)), RoundedMargin(margin[1].At(columns, rows)),
          RoundedMargin(margin[2].At(columns, rows))};
}

FootprintPattern FootprintSetup::PatternFor(int64_t major, int64_t minor, Tolerance tolerance) {
  constexpr int kToTurn = kTurn - Tolerance::kFraction;
  const Int128 t = major, s = minor, allowed = Int128{tolerance.raw()} << kToTurn;
  if (255 * (t + s) <= 8 * allowed) return FootprintPattern::kCentre;
  if (255 * ((16 * s << kTurn) + t * t) <= 128 * allowed << kTurn) return FootprintPattern::kTwo;
  if (255 * ((32 * t * s << kTurn) + t * t * t) <= 3072 * allowed << (2 * kTurn)) {
    return FootprintPattern::kFour;
  }
  return FootprintPattern::kEight;
}

std::array<FootprintOffset, 3> FootprintSetup::Offsets(FootprintPattern pattern, const Axis& major,
                                                       const Axis& minor) {
  // 30 fraction bits: 1/2, sqrt(1/2), sqrt(2/3), sqrt(1/6).
  constexpr int64_t kHalf = 1 << 29, kRootHalf = 759250125, kOuter = 876706528, kInner = 438353264;
  const auto mix = [&](int64_t a, int64_t b) {
    Raw normal, margin;
    for (size_t c = 0; c < 3; ++c) {
      normal[c] = RoundShift(
          static_cast<Int128>(a) * major.normal[c] + static_cast<Int128>(b) * minor.normal[c], 30);
      margin[c] = RoundShift(
          static_cast<Int128>(a) * major.margin[c] + static_cast<Int128>(b) * minor.margin[c], 30);
    }
    return OffsetOf(normal, margin);
  };
  switch (pattern) {
    case FootprintPattern::kTwo: return {mix(kHalf, 0), {}, {}};
    case FootprintPattern::kFour: return {mix(kRootHalf, 0), mix(0, kRootHalf), {}};
    case FootprintPattern::kEight:
      return {mix(kOuter, 0), mix(kInner, kRootHalf), mix(kInner, -kRootHalf)};
    default: return {};
  }
}

FootprintPattern FootprintSetup::Pattern(const Raw& major, const Raw& minor, const Raw& sum,
                                         const Material& material) const {
  const bool shiny = std::any_of(material.specular.begin(), material.specular.end(),
                                 [](Reflectance r) { return r.raw() != 0; });
  const int64_t n =
      std::max<int64_t>(shiny ? material.shininess.raw() : 0, int64_t{1} << Shininess::kFraction);
  const FootprintPattern wanted =
      PatternFor(TurnSquare(major, sum, n), TurnSquare(minor, sum, n), options_.tolerance);
  return std::clamp(wanted, options_.least, options_.most);
}

FootprintSetup::Result FootprintSetup::Of(const TrianglePacket& packet,
                                          const TriangleGeometry& geometry,
                                          const Material& material, int x, int y,
                                          const VertexWeights& weights) const {
  const bool paper = options_.form == FootprintForm::kPaper;
  Result result;
  result.vertex = Vertices(options_.form, packet, weights, &result.subdivide);
  const std::array<Edge, 3> edge = EdgesByVertex(geometry);
  const std::array<Raw, 3> normal = {RawOf(result.vertex[0]), RawOf(result.vertex[1]),
                                     RawOf(result.vertex[2])};
  Raw sum;
  for (size_t c = 0; c < 3; ++c) sum[c] = normal[0][c] + normal[1][c] + normal[2][c];
  const Slope slope = SlopeOf(edge, normal);
  const std::array<Raw, 3> vertex_margin = MarginsOfVertices(weights);
  const Slope margin_slope = paper ? SlopeOf(edge, vertex_margin) : Slope{};

  const FootprintReach reach(edge, geometry.area, paper ? 8 : 1);
  const auto along = [&](int64_t dx, int64_t dy) -> Axis {
    return {reach.Along(slope, dx, dy, kNormal, Quantity::kFraction),
            reach.Along(margin_slope, dx, dy, kNormal, Margin::kFraction)};
  };
  const FootprintAxes axes = FootprintAxes::Of(slope, sum);
  const Axis major = along(axes.x, axes.y), minor = along(-axes.y, axes.x);
  result.footprint.pattern = Pattern(major.normal, minor.normal, sum, material);
  result.footprint.offset = Offsets(result.footprint.pattern, major, minor);
  if (!paper) return result;
  result.margin = MarginPlanes(geometry, edge, vertex_margin, margin_slope, x, y);
  for (size_t k = 0; k < 3; ++k) {
    result.footprint.margin_dx[k] = RoundedMargin(result.margin[k].dx);
  }
  return result;
}

}  // namespace shading
