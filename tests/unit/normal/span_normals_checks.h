// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "model/normal/edge_normals.h"
#include "model/normal/span_normals.h"
#include "tests/unit/normal/normal_triangle_stimulus.h"
#include "tests/unit/raster/mesh_stimulus.h"

namespace shading {

using Real = long double;
inline constexpr double kBound = SpanNormals::kContract.max_error_ulp;
inline const Real kPi = std::acos(Real{-1});

inline TrianglePacket AnyTriangle(CornerGenerator* corners, std::mt19937& random) {
  TrianglePacket packet = PacketOf(corners->Any());
  packet.n = AnyNormals(corners, random);
  for (VertexDepth& z : packet.z) z = VertexDepth::FromRaw(corners->Integer(0, 0xffffff));
  return packet;
}

inline double SumLength(const ideal::Vector& a, const ideal::Vector& b) {
  const ideal::Vector sum = ideal::Sum(a, b);
  return std::sqrt(ideal::Dot(sum, sum));
}

// How near to opposed the normals of the triangle's edges and of the row through y are: the least
// |Na + Nb|. Exactly opposed edges are well defined and do not count.
inline double LeastSum(const TrianglePacket& packet, const ideal::Slerp& ideal, int y) {
  constexpr double kFar = 1e5;  // beyond both ends of every row
  double least = SumLength(ideal.Normal(-kFar, y + 0.5), ideal.Normal(kFar, y + 0.5));
  for (size_t i = 0; i < 3; ++i) {
    const double edge = SumLength(ideal::Normalised(ideal::ToReal(packet.n[i])),
                                  ideal::Normalised(ideal::ToReal(packet.n[(i + 1) % 3])));
    if (edge > 1e-12) least = std::min(least, edge);
  }
  return least;
}

// The largest errors of the normals at the ends of spans.
struct WorstEnds {
  double below_170 = 0;  // ulp
  double beyond = 0;     // (ulp - 0.5) |Na + Nb|
  double length = 0;     // | |N|^2 - 1 |

  void Measure(const Attached& t, const ideal::Slerp& ideal, const SpanCommand& span) {
    const double least = LeastSum(t.packet, ideal, span.y);
    for (const int end : {0, 1}) {
      const SpanNormal& n = span.normal[static_cast<size_t>(end)];
      const ideal::Vector real = RealOf(n);
      length = std::max(length, std::abs(ideal::Dot(real, real) - 1));
      if (least < 0x1p-22) continue;  // either side of the threshold
      const int x = span.x + (end ? span.length - 1 : 0);
      const double error = UlpsBetween(n, ideal.Normal(x + 0.5, span.y + 0.5));
      if (least > 2 * std::cos(85 * static_cast<double>(kPi) / 180)) {
        below_170 = std::max(below_170, error);
      } else {
        beyond = std::max(beyond, (error - 0.5) * least);
      }
    }
  }
};

// The recurrence down an edge of 4096 rows, the longest there is, against its closed form: each
// climb changes one thing about the edge and keeps what is worse.
struct LongEdge {
  Vector3 a, b;
  int64_t top = 0, bottom = 0;

  Real Error() const {  // ulp of S1.30
    const ArcVector na = UnitOf(a), nb = UnitOf(b);
    EdgeNormals edge(top, bottom, na, nb, 0);
    std::array<std::array<Real, 3>, 2> unit;
    Real sum = 0, difference = 0;
    for (size_t c = 0; c < 3; ++c) {
      unit[0][c] = std::ldexp(static_cast<Real>(na[c]), -kArcFraction);
      unit[1][c] = std::ldexp(static_cast<Real>(nb[c]), -kArcFraction);
      sum += (unit[0][c] + unit[1][c]) * (unit[0][c] + unit[1][c]);
      difference += (unit[1][c] - unit[0][c]) * (unit[1][c] - unit[0][c]);
    }
    const Real psi = 2 * std::atan2(std::sqrt(difference), std::sqrt(sum));
    Real worst = 0;
    for (int row = 95; row < 4096; row += 400) {
      const ArcVector n = edge.At(row);
      const Real w =
          static_cast<Real>(row * kPixel + kPixel / 2 - top) / static_cast<Real>(bottom - top);
      for (size_t c = 0; c < 3; ++c) {
        const Real expected =
            psi < 1e-12L ? unit[0][c]
                         : (std::sin((1 - w) * psi) * unit[0][c] + std::sin(w * psi) * unit[1][c]) /
                               std::sin(psi);
        const Real actual = std::ldexp(static_cast<Real>(n[c]), -kArcFraction);
        worst = std::max(worst, std::abs(std::ldexp(expected - actual, 30)));
      }
    }
    return worst;
  }
};

// Walks `parts` along `whole`; returns how many of the latter were split.
inline int64_t ExpectTiling(const Attached& t) {
  size_t part = 0;
  int64_t splits = 0;
  for (const SpanCommand& whole : t.whole) {
    int done = 0;
    for (; done < whole.length && part < t.spans.size(); ++part) {
      const SpanCommand& span = t.spans[part];
      splits += done > 0;
      EXPECT_EQ(span.y, whole.y);
      EXPECT_EQ(span.x, whole.x + done);
      EXPECT_EQ(span.z, DepthAcc::Wrap(whole.z.raw() + done * t.dz_dx.raw()));
      EXPECT_GT(span.length, 0);
      done += span.length;
      EXPECT_EQ(span.last, whole.last && done == whole.length);
      const double dot = ideal::Dot(RealOf(span.normal[0]), RealOf(span.normal[1]));
      EXPECT_GE(dot, -0x1p-26);
    }
    EXPECT_EQ(done, whole.length);
  }
  EXPECT_EQ(part, t.spans.size());
  return splits;
}

}  // namespace shading
