// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include "model/fixed/wide_integer.h"
#include "model/shading_types.h"
#include "model/triangle_packet.h"

namespace shading {

inline constexpr int64_t kPixel = int64_t{1} << ScreenCoord::kFraction;
inline constexpr int64_t kGuardBand = 8191 * kPixel;

struct Point {
  int64_t x = 0, y = 0;  // raw S13.8, y down
};
using Corners = std::array<Point, 3>;

// Twice the area of abc in 2^-16 square pixels; positive is clockwise as seen on the screen.
inline Int128 Cross(Point a, Point b, Point c) {
  return static_cast<Int128>(b.x - a.x) * (c.y - a.y) -
         static_cast<Int128>(c.x - a.x) * (b.y - a.y);
}

inline FrameState Screen(int width, int height, Cull cull = Cull::kNone) {
  FrameState frame;
  frame.width = width;
  frame.height = height;
  frame.cull = cull;
  return frame;
}

inline TrianglePacket PacketOf(const Corners& corner) {
  TrianglePacket packet;
  for (size_t i = 0; i < 3; ++i) {
    packet.x[i] = ScreenCoord::FromRaw(corner[i].x);
    packet.y[i] = ScreenCoord::FromRaw(corner[i].y);
  }
  return packet;
}

inline bool Same(const Surface& s, const Surface& t) {
  return s.a == t.a && s.b == t.b && s.c == t.c && s.d == t.d && s.e == t.e && s.f == t.f;
}

// Coverage and weights of a triangle in exact integers, from the definition. Corners are numbered
// as in the packet; either orientation; the area must not be 0.
class ExactTriangle {
 public:
  explicit ExactTriangle(const TrianglePacket& packet) {
    for (size_t i = 0; i < 3; ++i) corner_[i] = {packet.x[i].raw(), packet.y[i].raw()};
    sign_ = Cross(corner_[0], corner_[1], corner_[2]) < 0 ? -1 : 1;
  }

  Int128 area() const { return sign_ * Cross(corner_[0], corner_[1], corner_[2]); }
  // area() times the barycentric of corner i at the centre of a pixel.
  Int128 Weight(size_t i, int x, int y) const {
    const Point centre = {x * kPixel + kPixel / 2, y * kPixel + kPixel / 2};
    return sign_ * Cross(centre, corner_[(i + 1) % 3], corner_[(i + 2) % 3]);
  }
  std::array<Int128, 3> Weights(int x, int y) const {
    return {Weight(0, x, y), Weight(1, x, y), Weight(2, x, y)};
  }

  // The top-left rule as a nudge: a centre on an edge moves right by an infinitesimal, and down by
  // a far smaller one, and is then either in or out.
  bool Nudged(size_t i) const {
    const Point a = corner_[(i + 1) % 3], b = corner_[(i + 2) % 3];
    const int64_t along_x = sign_ * (a.y - b.y), along_y = sign_ * (b.x - a.x);
    return along_x != 0 ? along_x > 0 : along_y > 0;
  }
  bool Covers(int x, int y) const {
    for (size_t i = 0; i < 3; ++i) {
      const Int128 w = Weight(i, x, y);
      if (w < 0 || (w == 0 && !Nudged(i))) return false;
    }
    return true;
  }

 private:
  Corners corner_;
  int sign_;
};

// Corners of random triangles for a screen.
class CornerGenerator {
 public:
  CornerGenerator(uint32_t seed, int width, int height)
      : random_(seed), width_(width * kPixel), height_(height * kPixel) {}

  int64_t Integer(int64_t low, int64_t high) {
    return std::uniform_int_distribution<int64_t>(low, high)(random_);
  }
  Point OnScreen() { return {Integer(-300, width_ + 300), Integer(-300, height_ + 300)}; }
  Point InGuardBand() {
    return {Integer(-kGuardBand, kGuardBand), Integer(-kGuardBand, kGuardBand)};
  }
  Point Near(Point p, int64_t reach) {
    const auto clamp = [](int64_t v) { return std::clamp(v, -kGuardBand, kGuardBand); };
    return {clamp(p.x + Integer(-reach, reach)), clamp(p.y + Integer(-reach, reach))};
  }

  Corners Small() {
    const Point a = OnScreen();
    const int64_t reach = kPixel << Integer(0, 6);
    return {a, Near(a, reach), Near(a, reach)};
  }
  // Two corners beyond opposite corners of the screen, the third anywhere.
  Corners WholeScreen() {
    const int64_t reach = int64_t{1} << Integer(2, 19);
    Corners corner = {Point{-Integer(0, reach), -Integer(0, reach)},
                      Point{width_ + Integer(0, reach), height_ + Integer(0, reach)},
                      InGuardBand()};
    if (Integer(0, 1)) {
      for (Point& p : corner) p.x = width_ - p.x;
    }
    for (Point& p : corner) p = Near(p, 0);
    return corner;
  }
  // The third corner lies within 3/256 pixel of the line through the other two.
  Corners Sliver() {
    const Corners ends = Integer(0, 1) ? WholeScreen() : Corners{OnScreen(), OnScreen(), {}};
    const int64_t t = Integer(0, 1 << 20);
    const Point between = {ends[0].x + (((ends[1].x - ends[0].x) * t) >> 20),
                           ends[0].y + (((ends[1].y - ends[0].y) * t) >> 20)};
    return {ends[0], ends[1], Near(between, 3)};
  }
  // Corners on centres of pixels; edges often run along a row or a column of them.
  Corners OnCentres() {
    const Point a = OnScreen();
    Corners corner = {a, Near(a, 5 * kPixel), Near(a, 5 * kPixel)};
    for (Point& p : corner) {
      p = {FloorDivide(p.x, kPixel) * kPixel + kPixel / 2,
           FloorDivide(p.y, kPixel) * kPixel + kPixel / 2};
    }
    return corner;
  }
  Corners Any() {
    switch (Integer(0, 5)) {
      case 0: return WholeScreen();
      case 1: return Sliver();
      case 2: return {InGuardBand(), InGuardBand(), InGuardBand()};
      case 3: return {OnScreen(), OnScreen(), OnScreen()};
      case 4: return OnCentres();
      default: return Small();
    }
  }

 private:
  std::mt19937 random_;
  int64_t width_, height_;
};

// The ends of the spans where errors grow largest: the first and the last three rows, every 61st.
template <typename Function>
void ForFarPixels(const std::vector<SpanCommand>& spans, Function function) {
  for (size_t i = 0; i < spans.size(); i += i < 2 || i + 4 > spans.size() ? 1 : 61) {
    function(spans[i].x, spans[i].y);
    function(spans[i].x + spans[i].length - 1, spans[i].y);
  }
}

}  // namespace shading
