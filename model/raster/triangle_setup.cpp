// SPDX-License-Identifier: Apache-2.0
#include "model/raster/triangle_setup.h"

#include <algorithm>
#include <utility>

#include "model/fixed/wide_integer.h"

namespace shading {
namespace {

constexpr int64_t kPixel = int64_t{1} << ScreenCoord::kFraction;
constexpr int64_t kCentre = kPixel / 2;

// Indices of the first and last pixel whose centre lies in [low, high].
std::pair<int64_t, int64_t> CentresWithin(int64_t low, int64_t high) {
  return {FloorDivide(low - kCentre + kPixel - 1, kPixel), FloorDivide(high - kCentre, kPixel)};
}

struct Range {
  int first = 0, count = 0;
  Verdict verdict = Verdict::kDraw;
};

Range ClipAxis(const std::array<ScreenCoord, 3>& v, int size) {
  const auto [low, high] = std::minmax({v[0].raw(), v[1].raw(), v[2].raw()});
  if (high < 0 || low > size * kPixel) return {0, 0, Verdict::kOffScreen};
  const auto [first, last] = CentresWithin(low, high);
  const int64_t from = std::max<int64_t>(first, 0);
  const int64_t to = std::min<int64_t>(last, size - 1);
  if (from > to) return {0, 0, Verdict::kEmpty};
  return {static_cast<int>(from), static_cast<int>(to - from + 1), Verdict::kDraw};
}

// From corner a to corner b; the inside is where the cross product is positive.
Edge MakeEdge(const TrianglePacket& packet, const TriangleGeometry& g, int a, int b) {
  const auto va = static_cast<size_t>(a);
  const auto vb = static_cast<size_t>(b);
  const int64_t run = packet.x[vb].raw() - packet.x[va].raw();
  const int64_t rise = packet.y[vb].raw() - packet.y[va].raw();
  const int64_t x = g.box_x * kPixel + kCentre - packet.x[va].raw();
  const int64_t y = g.box_y * kPixel + kCentre - packet.y[va].raw();
  return {run * y - rise * x, -rise * kPixel, run * kPixel, rise < 0 || (rise == 0 && run > 0)};
}

}  // namespace

Verdict TriangleSetup::Setup(const TrianglePacket& packet, const FrameState& frame,
                             TriangleGeometry* geometry) {
  const auto& x = packet.x;
  const auto& y = packet.y;
  const int64_t area = (x[1].raw() - x[0].raw()) * (y[2].raw() - y[0].raw()) -
                       (x[2].raw() - x[0].raw()) * (y[1].raw() - y[0].raw());
  if (area == 0) return Verdict::kDegenerate;
  if (area > 0 && frame.cull == Cull::kBack) return Verdict::kBackFacing;

  const Range columns = ClipAxis(x, frame.width);
  const Range rows = ClipAxis(y, frame.height);
  for (const Verdict reject : {Verdict::kOffScreen, Verdict::kEmpty}) {
    if (columns.verdict == reject || rows.verdict == reject) return reject;
  }

  geometry->area = area < 0 ? -area : area;
  geometry->corner = area < 0 ? std::array<int, 3>{0, 2, 1} : std::array<int, 3>{0, 1, 2};
  geometry->box_x = columns.first;
  geometry->box_y = rows.first;
  geometry->columns = columns.count;
  geometry->rows = rows.count;
  for (size_t i = 0; i < 3; ++i) {
    geometry->edge[i] = MakeEdge(packet, *geometry, geometry->corner[(i + 1) % 3],
                                 geometry->corner[(i + 2) % 3]);
  }
  return Verdict::kDraw;
}

std::array<Plane, 3> TriangleSetup::Barycentrics(const TriangleGeometry& geometry, int x, int y) {
  const auto quantise = [&](int64_t w) {
    const Int128 scaled = static_cast<Int128>(w) * (int64_t{1} << kBarycentricFraction);
    return static_cast<uint64_t>(RoundDivide(scaled, geometry.area));
  };
  const int64_t column = x - geometry.box_x, row = y - geometry.box_y;
  std::array<Plane, 3> plane;
  for (size_t i = 0; i < 2; ++i) {
    const Edge& edge = geometry.edge[i];
    plane[i] = {quantise(edge.w0 + column * edge.dx + row * edge.dy), quantise(edge.dx),
                quantise(edge.dy)};
  }
  constexpr uint64_t kOne = uint64_t{1} << kBarycentricFraction;
  plane[2] = {kOne - plane[0].at_origin - plane[1].at_origin, -plane[0].dx - plane[1].dx,
              -plane[0].dy - plane[1].dy};
  return plane;
}

Plane TriangleSetup::DepthPlane(const TriangleGeometry& geometry, const TrianglePacket& packet) {
  Int128 at_origin = 0, dx = 0, dy = 0;
  for (size_t i = 0; i < 3; ++i) {
    const int64_t z = packet.z[static_cast<size_t>(geometry.corner[i])].raw();
    at_origin += static_cast<Int128>(geometry.edge[i].w0) * z;
    dx += static_cast<Int128>(geometry.edge[i].dx) * z;
    dy += static_cast<Int128>(geometry.edge[i].dy) * z;
  }
  constexpr int kGuard = DepthAcc::kFraction - VertexDepth::kFraction;
  const auto quantise = [&](Int128 sum) {
    return static_cast<uint64_t>(RoundDivide(sum * (1 << kGuard), geometry.area));
  };
  constexpr uint64_t kHalfUlp = uint64_t{1} << (kGuard - 1);
  return {quantise(at_origin) + kHalfUlp, quantise(dx), quantise(dy)};
}

}  // namespace shading
