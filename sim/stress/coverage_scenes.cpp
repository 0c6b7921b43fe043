// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <random>

#include "model/raster/span_walker.h"
#include "sim/stress/triangle_genes.h"
#include "sim/stress/trouble.h"

namespace shading::stress {
namespace {

constexpr int64_t kPixel = int64_t{1} << ScreenCoord::kFraction;
constexpr int64_t kBand = 8191 * kPixel;

struct Point {
  int64_t x, y;  // raw S13.8
};

// How often each pixel of a screen is covered.
class Counted {
 public:
  Counted(int width, int height)
      : frame_(FrameOf(width, height)), times_(static_cast<size_t>(width * height)) {}

  void Draw(Point a, Point b, Point c) {
    TrianglePacket packet;
    const std::array<Point, 3> corner = {a, b, c};
    for (size_t i = 0; i < 3; ++i) {
      packet.x[i] = ScreenCoord::FromRaw(corner[i].x);
      packet.y[i] = ScreenCoord::FromRaw(corner[i].y);
    }
    TriangleGeometry geometry;
    if (TriangleSetup::Setup(packet, frame_, &geometry) != Verdict::kDraw) return;
    spans_.clear();
    SpanWalker::Walk(geometry, {}, &spans_);
    for (const SpanCommand& span : spans_) {
      uint8_t* row = &times_[static_cast<size_t>(span.y * frame_.width)];
      for (int x = span.x; x < span.x + span.length; ++x) ++row[x];
    }
  }
  int64_t NotOnce() const {
    return std::count_if(times_.begin(), times_.end(), [](uint8_t n) { return n != 1; });
  }
  int64_t size() const { return static_cast<int64_t>(times_.size()); }

 private:
  FrameState frame_;
  std::vector<uint8_t> times_;
  std::vector<SpanCommand> spans_;
};

int64_t Integer(std::mt19937& random, int64_t low, int64_t high) {
  return std::uniform_int_distribution<int64_t>(low, high)(random);
}

// Needles from one point to the border of the whole guard band, most of them on few rows.
void Fan(int needles, Point centre, std::mt19937& random, Counted* counted) {
  std::vector<Point> border;
  const std::array<Point, 4> corner = {
      Point{-kBand, -kBand}, {kBand, -kBand}, {kBand, kBand}, {-kBand, kBand}};
  for (size_t side = 0; side < 4; ++side) {
    std::vector<int64_t> at = {0};
    for (int i = 0; i < needles / 4; ++i) at.push_back(Integer(random, 1, 2 * kBand - 1));
    std::sort(at.begin(), at.end());
    const Point p = corner[side], q = corner[(side + 1) % 4];
    for (const int64_t t : at)
      border.push_back({p.x + (q.x > p.x   ? t
                               : q.x < p.x ? -t
                                           : 0),
                        p.y + (q.y > p.y   ? t
                               : q.y < p.y ? -t
                                           : 0)});
  }
  for (size_t i = 0; i < border.size(); ++i)
    counted->Draw(centre, border[i], border[(i + 1) % border.size()]);
}

Condition Fans(bool quick, uint32_t seed) {
  Condition c{"coverage", "fans of 16..4000 needles over the guard band, 16382 pixels wide",
              "pixels not covered exactly once"};
  std::mt19937 random(seed);
  for (int i = 0; i < (quick ? 30 : 600); ++i) {
    Counted counted(200, 150);
    // The hub on a pixel's centre, on its corner, or anywhere.
    Point hub = {Integer(random, 0, 200 * kPixel), Integer(random, 0, 150 * kPixel)};
    if (i % 3 == 0) hub = {hub.x & ~(kPixel - 1), hub.y & ~(kPixel - 1)};
    if (i % 3 == 1) hub = {(hub.x & ~(kPixel - 1)) + 128, (hub.y & ~(kPixel - 1)) + 128};
    Fan(1 << (4 + i % 9), hub, random, &counted);
    c.worst += static_cast<double>(counted.NotOnce());
    c.cases += counted.size();
  }
  return c;
}

// A grid with vertices moved by less than half a cell; cells of 1/4 to 32 pixels.
Condition Grids(bool quick, uint32_t seed) {
  Condition c{"coverage", "grids of cells of 1/4..32 pixels, vertices moved, on centres or between",
              "pixels not covered exactly once"};
  std::mt19937 random(seed + 1);
  for (int i = 0; i < (quick ? 24 : 480); ++i) {
    Counted counted(64, 48);
    const int64_t cell = int64_t{64} << (i % 8);
    const int64_t across = 64 * kPixel / cell + 3, down = 48 * kPixel / cell + 3;
    const int64_t grain = i % 3 == 0 ? 1 : i % 3 == 1 ? cell / 4 : 128;
    std::vector<Point> at;
    for (int64_t y = 0; y < down; ++y) {
      for (int64_t x = 0; x < across; ++x) {
        const auto moved = [&](int64_t n) {
          return (n - 1) * cell + Integer(random, -cell / 4 / grain, cell / 4 / grain) * grain;
        };
        at.push_back({moved(x), moved(y)});
      }
    }
    for (int64_t y = 0; y + 1 < down; ++y) {
      for (int64_t x = 0; x + 1 < across; ++x) {
        const auto k = static_cast<size_t>(y * across + x), w = static_cast<size_t>(across);
        counted.Draw(at[k], at[k + 1], at[k + w]);
        counted.Draw(at[k + 1], at[k + w + 1], at[k + w]);
      }
    }
    c.worst += static_cast<double>(counted.NotOnce());
    c.cases += counted.size();
  }
  return c;
}

// Three vertices on a line, anywhere in the guard band.
Condition Flat(bool quick, uint32_t seed) {
  Condition c{"coverage", "triangles of no area", "triangles drawn"};
  std::mt19937 random(seed + 2);
  for (c.cases = 0; c.cases < (quick ? 20000 : 400000); ++c.cases) {
    const int64_t dx = Integer(random, -900, 900), dy = Integer(random, -900, 900);
    const int64_t x = Integer(random, 0, kBand / 2), y = Integer(random, 0, kBand / 2);
    TrianglePacket packet;
    for (size_t i = 0; i < 3; ++i) {
      const int64_t t = Integer(random, -1000, 1000);
      packet.x[i] = ScreenCoord::FromRaw(std::clamp(x + t * dx, -kBand, kBand));
      packet.y[i] = ScreenCoord::FromRaw(std::clamp(y + t * dy, -kBand, kBand));
    }
    TriangleGeometry geometry;
    if (ExactWeights(packet).area() != 0) continue;
    const Verdict verdict = TriangleSetup::Setup(packet, FrameOf(4096, 4096), &geometry);
    c.worst += verdict == Verdict::kDraw;
  }
  return c;
}

}  // namespace

std::vector<Scene> CoverageScenes() { return {Fans, Grids, Flat}; }

}  // namespace shading::stress
