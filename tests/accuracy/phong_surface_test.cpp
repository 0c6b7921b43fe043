// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include "model/choice/method_choice.h"
#include "model/ideal/barycentric.h"
#include "model/normal/phong_surface_shader.h"
#include "model/raster/span_setup.h"
#include "model/raster/span_walker.h"
#include "model/raster/triangle_fit.h"

namespace shading {
namespace {

using Real3 = std::array<double, 3>;

double Dot(const Real3& a, const Real3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Real3 RealOf(const Vector3& v) { return {v[0].ToReal(), v[1].ToReal(), v[2].ToReal()}; }
Vector3 Rounded(Real3 v) {
  const double length = std::sqrt(Dot(v, v));
  return {NormalComponent::Round(v[0] / length), NormalComponent::Round(v[1] / length),
          NormalComponent::Round(v[2] / length)};
}

// What the search moves.
struct Candidate {
  std::array<double, 3> x, y;  // pixels
  std::array<Real3, 3> normal;
  Real3 light;
  double along = 0, across = 0;  // 0..1: which covered pixel
};

class Search {
 public:
  Search(int size, double least_turn, double most_turn, unsigned seed)
      : size_(size), least_turn_(least_turn), most_turn_(most_turn), random_(seed) {}

  struct Worst {
    double cosine = 0;  // largest error of N.L
    double share = 0;   // largest of its bound at the same pixel
    int triangles = 0;
  };

  Worst Run(int restarts, int moves) {
    for (int i = 0; i < restarts; ++i) {
      Candidate best = Start();
      double found = Try(best);
      for (int k = 0; k < moves; ++k) {
        const Candidate next = Moved(best, std::exp2(-(k % 14)));
        const double error = Try(next);
        if (error < found) continue;
        found = error;
        best = next;
      }
    }
    return worst_;
  }

 private:
  double Uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double Gauss() { return std::normal_distribution<double>()(random_); }
  Real3 Direction() { return {Gauss(), Gauss(), Gauss()}; }

  Candidate Start() {
    Candidate c;
    const bool sliver = random_() % 4 == 0;
    for (size_t i = 0; i < 3; ++i) {
      c.x[i] = sliver && i > 0 ? c.x[0] + Uniform(0, 3) : Uniform(0, size_);
      c.y[i] = Uniform(0, size_);
      c.normal[i] = Direction();
    }
    const double spread = std::exp2(Uniform(-6, 1));
    for (size_t i = 1; i < 3; ++i) {
      for (size_t k = 0; k < 3; ++k) c.normal[i][k] = c.normal[0][k] + spread * c.normal[i][k];
    }
    c.light = Direction();
    c.along = Uniform(0, 1);
    c.across = Uniform(0, 1);
    return c;
  }

  Candidate Moved(Candidate c, double scale) {
    for (size_t i = 0; i < 3; ++i) {
      c.x[i] = std::clamp(c.x[i] + scale * size_ * Gauss() / 4, 0.0, double(size_));
      c.y[i] = std::clamp(c.y[i] + scale * size_ * Gauss() / 4, 0.0, double(size_));
      for (size_t k = 0; k < 3; ++k) {
        c.normal[i][k] += scale * Gauss() / 4;
        c.light[k] += scale * Gauss() / 4;
      }
    }
    c.along = std::clamp(c.along + scale * Gauss() / 4, 0.0, 1.0);
    c.across = std::clamp(c.across + scale * Gauss() / 4, 0.0, 1.0);
    return c;
  }

  // The error of N.L at the candidate's pixel; below 0 where there is none.
  double Try(const Candidate& c) {
    TrianglePacket packet;
    double turn = 0;
    for (size_t i = 0; i < 3; ++i) {
      packet.x[i] = ScreenCoord::Round(c.x[i]);
      packet.y[i] = ScreenCoord::Round(c.y[i]);
      packet.n[i] = Rounded(c.normal[i]);
    }
    for (size_t i = 0; i < 3; ++i) {
      Real3 chord = RealOf(packet.n[i]);
      for (size_t k = 0; k < 3; ++k) chord[k] -= packet.n[(i + 1) % 3][k].ToReal();
      turn = std::max(turn, Dot(chord, chord));
    }
    if (turn > most_turn_ || turn < least_turn_) return -1;
    FrameState frame;
    frame.width = frame.height = size_;
    frame.cull = Cull::kNone;
    frame.light = frame.half = frame.view = Rounded(c.light);
    frame.materials.resize(1);
    TriangleGeometry geometry;
    if (TriangleSetup::Setup(packet, frame, &geometry) != Verdict::kDraw) return -1;
    spans_.clear();
    SpanWalker::Walk(geometry, {}, &spans_);
    if (spans_.empty()) return -1;
    ++worst_.triangles;
    return ErrorAt(c, packet, frame, geometry);
  }

  double ErrorAt(const Candidate& c, const TrianglePacket& packet, const FrameState& frame,
                 const TriangleGeometry& geometry) {
    TriangleState triangle;
    triangle.origin_x = spans_[0].x;
    triangle.origin_y = spans_[0].y;
    TriangleFit(frame).Fit(packet, geometry, ChoiceOf(Method::kPhongSurface), spans_[0].x,
                           spans_[0].y, &triangle);
    const double last = static_cast<double>(spans_.size() - 1);
    SpanCommand span = spans_[static_cast<size_t>(std::lround(c.across * last))];
    span.x += static_cast<int>(std::lround(c.along * (span.length - 1)));
    const SpanSeed seed = SpanSetup::Seed(Method::kPhongSurface, triangle, span);
    const double cosine =
        PhongSurfaceShader<1>(seed.curve).At(0, LightOf(frame)).n_dot_l.ToReal();
    const auto weight = ideal::Barycentric(packet).AtPixel(span.x, span.y);
    Real3 normal = {};
    for (size_t i = 0; i < 3; ++i) {
      for (size_t k = 0; k < 3; ++k) normal[k] += weight[i] * packet.n[i][k].ToReal();
    }
    const double square = Dot(normal, normal);
    const double error =
        std::abs(cosine - Dot(normal, RealOf(frame.light)) / std::sqrt(square));
    worst_.cosine = std::max(worst_.cosine, error);
    worst_.share = std::max(worst_.share, error / Bound(span.x - triangle.origin_x,
                                                        span.y - triangle.origin_y, square));
    return error;
  }

  // What docs/accuracy.md says: coefficients of |N|^2 and N.L, barycentrics, roundings.
  static double Bound(double x, double y, double square) {
    x = std::abs(x);
    const double root = std::sqrt(square);
    return (x * x + x * y + y * y + x + y + 1) * 0x1p-45 / (2 * square) +
           (x + y + 1) * (0x1p-45 + 3 * 0x1p-34) / root + 0x1p-30 / root + 88.2 * 0x1p-30;
  }

  int size_;
  double least_turn_, most_turn_;
  std::mt19937 random_;
  std::vector<SpanCommand> spans_;
  Worst worst_;
};

const double kMostTurn = std::ldexp(double(MethodChoice::kSurfaceTurn), -Turn::kFraction);

TEST(PhongSurface, WithinErrorBound) {
  for (const auto& [size, bound] : {std::pair{2048, 3.0e-6}, {kMaxScreen, 8.0e-6}}) {
    const Search::Worst worst = Search(size, 0, kMostTurn, 7).Run(30, 400);
    std::printf("%d pixels: %.3g, %.2f of the bound\n", size, worst.cosine, worst.share);
    EXPECT_LE(worst.share, 1);
    EXPECT_LE(worst.cosine, bound) << size;
    EXPECT_GT(worst.cosine, bound / 20) << "the search is blind";
    EXPECT_GT(worst.triangles, 1000);
  }
}

// Beyond the turn that it is meant for the root of |N|^2 loses its digits.
TEST(PhongSurface, OpposedNormalsNeedPhongDuff) {
  const Search::Worst inside = Search(kMaxScreen, 0, kMostTurn, 3).Run(30, 400);
  const Search::Worst beyond = Search(kMaxScreen, 3.9, 4, 3).Run(30, 400);
  std::printf("inside %.3g, beyond %.3g\n", inside.cosine, beyond.cosine);
  EXPECT_GT(beyond.cosine, 10 * inside.cosine);
}

}  // namespace
}  // namespace shading
