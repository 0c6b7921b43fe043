// SPDX-License-Identifier: Apache-2.0
#include "sim/stress/triangle_genes.h"

#include <algorithm>

#include "sim/stress/vectors.h"

namespace shading::stress {
namespace {

constexpr int64_t kPixel = int64_t{1} << ScreenCoord::kFraction;
constexpr double kBand = 8191;

using Point = std::array<double, 2>;  // pixels

Point Clamped(Point p) {
  return {std::clamp(p[0], -kBand, kBand), std::clamp(p[1], -kBand, kBand)};
}
// How far beyond a corner of the screen: even in the logarithm, 2^-8..4000 pixels.
double Beyond(double gene) { return Geometric(1.0 / 256, 4000, gene); }

std::array<Point, 3> Points(const Genes& g, double width, double height) {
  const auto anywhere = [&](size_t i) {
    return Point{Between(-kBand, kBand, g[i]), Between(-kBand, kBand, g[i + 1])};
  };
  const auto on_screen = [&](size_t i) {
    return Point{Between(-2, width + 2, g[i]), Between(-2, height + 2, g[i + 1])};
  };
  const int kind = std::min(4, static_cast<int>(5 * g[0]));
  const Point low = {-Beyond(g[1]), -Beyond(g[2])};
  const Point high = {width + Beyond(g[3]), height + Beyond(g[4])};
  if (kind == 0) return {anywhere(1), anywhere(3), anywhere(5)};
  if (kind == 1) return {low, high, anywhere(5)};
  if (kind == 3) {
    const Point a = on_screen(1);
    const auto near = [&](size_t i) {
      return Point{a[0] + Between(-64, 64, g[i]), a[1] + Between(-64, 64, g[i + 1])};
    };
    return {a, near(3), near(5)};
  }
  const Point a = kind == 2 ? on_screen(1) : low, b = kind == 2 ? on_screen(3) : high;
  const double off = std::round(Between(-3, 3, g[6])) / 256;
  return {a, b, {a[0] + (b[0] - a[0]) * g[5], a[1] + (b[1] - a[1]) * g[5] + off}};
}

}  // namespace

FrameState FrameOf(int width, int height) {
  FrameState frame;
  frame.width = width;
  frame.height = height;
  frame.cull = Cull::kNone;
  const Vector3 ahead = Rounded<NormalComponent>(Vector{0, 0, 1});
  frame.light = frame.half = frame.view = ahead;
  Material grey;
  const Reflectance part = Reflectance::Round(0.5);
  grey.diffuse = grey.specular = {part, part, part};
  grey.shininess = Shininess::Round(32);
  frame.materials = {grey};
  return frame;
}

TrianglePacket CornersOf(const Genes& genes, int width, int height) {
  TrianglePacket packet;
  const auto points = Points(genes, width, height);
  for (size_t i = 0; i < 3; ++i) {
    const Point p = Clamped(points[i]);
    packet.x[i] = ScreenCoord::Round(p[0]);
    packet.y[i] = ScreenCoord::Round(p[1]);
    packet.n[i] = Rounded<NormalComponent>(Vector{0, 0, 1});
  }
  return packet;
}

std::array<Vector3, 3> NormalsOf(const Genes& genes, size_t first) {
  std::array<Vector3, 3> n;
  for (size_t i = 0; i < 3; ++i)
    n[i] = Rounded<NormalComponent>(Direction(genes[first + 2 * i], genes[first + 2 * i + 1]));
  return n;
}

std::array<Vector3, 3> NearNormals(const Genes& g, size_t first, bool opposed) {
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

ExactWeights::ExactWeights(const TrianglePacket& packet) {
  for (size_t i = 0; i < 3; ++i) corner_[i] = {packet.x[i].raw(), packet.y[i].raw()};
  const auto& [a, b, c] = corner_;
  const Int128 area = Int128{b[0] - a[0]} * (c[1] - a[1]) - Int128{c[0] - a[0]} * (b[1] - a[1]);
  sign_ = area < 0 ? -1 : 1;
  area_ = sign_ * area;
}

Int128 ExactWeights::At(size_t vertex, int x, int y) const {
  const auto& a = corner_[(vertex + 1) % 3];
  const auto& b = corner_[(vertex + 2) % 3];
  const int64_t px = x * kPixel + kPixel / 2, py = y * kPixel + kPixel / 2;
  return sign_ * (Int128{a[0] - px} * (b[1] - py) - Int128{b[0] - px} * (a[1] - py));
}

bool ExactWeights::Covers(int x, int y) const {
  for (size_t i = 0; i < 3; ++i) {
    const Int128 w = At(i, x, y);
    if (w < 0) return false;
    if (w > 0) continue;
    const Int128 right = Dx(i), down = Dy(i);
    if (right < 0 || (right == 0 && down <= 0)) return false;
  }
  return true;
}

// Bounds from real numbers, made exact by Covers.
std::array<int, 2> ExactWeights::Row(int y, int left, int columns) const {
  Real low = left, high = left + columns - 1;
  for (size_t i = 0; i < 3; ++i) {
    const auto w = static_cast<Real>(At(i, left, y)), dx = static_cast<Real>(Dx(i));
    if (dx > 0) low = std::max(low, left - w / dx);
    if (dx < 0) high = std::min(high, left - w / dx);
    if (dx == 0 && w < 0) return {0, 0};
  }
  if (high < low - 2) return {0, 0};
  int first = std::max(left, static_cast<int>(std::floor(low)) - 1);
  int last = std::min(left + columns - 1, static_cast<int>(std::ceil(high)) + 1);
  while (first <= last && !Covers(first, y)) ++first;
  while (last >= first && !Covers(last, y)) --last;
  return first <= last ? std::array<int, 2>{first, last + 1} : std::array<int, 2>{0, 0};
}

std::vector<std::array<int, 2>> FarPixels(const ExactWeights& weights, const TriangleGeometry& g) {
  std::vector<std::array<int, 2>> far;
  const auto row = [&](int y) {
    const auto [first, end] = weights.Row(y, g.box_x, g.columns);
    if (first == end) return false;
    far.push_back({first, y});
    far.push_back({end - 1, y});
    return true;
  };
  int top = g.box_y, bottom = g.box_y + g.rows - 1;
  while (top <= bottom && !row(top)) ++top;
  if (top > bottom) return far;
  while (bottom > top && !row(bottom)) --bottom;
  for (const int y : {top + 1, (top + bottom) / 2, bottom - 1}) {
    if (y > top && y < bottom) row(y);
  }
  return far;
}

}  // namespace shading::stress
