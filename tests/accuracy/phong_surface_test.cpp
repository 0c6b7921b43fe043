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
  Real3 light, half;
  double along = 0, across = 0;  // 0..1: which covered pixel
};

class Search {
 public:
  // dropped: bits that the coefficients have less.
  Search(int size, double least_turn, double most_turn, int dropped = 0)
      : size_(size), least_turn_(least_turn), most_turn_(most_turn), dropped_(dropped) {}

  struct Worst {
    double cosine = 0;  // largest error of N.L or N.H
    double share = 0;   // largest of the surfaces' part of the bound at the same pixel
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
    if (least_turn_ > 3) {
      for (size_t k = 0; k < 3; ++k) c.normal[1][k] = 0.03 * Gauss() - c.normal[0][k];
    }
    c.light = Direction();
    c.half = Direction();
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
        c.half[k] += scale * Gauss() / 4;
      }
    }
    c.along = std::clamp(c.along + scale * Gauss() / 4, 0.0, 1.0);
    c.across = std::clamp(c.across + scale * Gauss() / 4, 0.0, 1.0);
    return c;
  }

  // The larger error at the candidate's pixel; below 0 where there is none.
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
    frame.light = Rounded(c.light);
    frame.half = Rounded(c.half);
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
    for (CosineSurface& curve : triangle.curve) Narrow(&curve);
    const double last = static_cast<double>(spans_.size() - 1);
    const SpanCommand span = spans_[static_cast<size_t>(std::lround(c.across * last))];
    const int k = static_cast<int>(std::lround(c.along * (span.length - 1)));
    const LightCosines shown = Shown(triangle, span, k, LightOf(frame));
    const auto weight = ideal::Barycentric(packet).AtPixel(span.x + k, span.y);
    Real3 normal = {};
    for (size_t i = 0; i < 3; ++i) {
      for (size_t j = 0; j < 3; ++j) normal[j] += weight[i] * packet.n[i][j].ToReal();
    }
    const double square = Dot(normal, normal);
    const double error = std::max(
        std::abs(shown.n_dot_l.ToReal() - Dot(normal, RealOf(frame.light)) / std::sqrt(square)),
        std::abs(shown.n_dot_h_or_v.ToReal() -
                 Dot(normal, RealOf(frame.half)) / std::sqrt(square)));
    const double rest = DuffNormalizer::kContract.max_error_ulp * 0x1p-30;
    const double share = (error - rest) / Bound(span.x + k - triangle.origin_x,
                                                span.y - triangle.origin_y, square);
    worst_.cosine = std::max(worst_.cosine, error);
    worst_.share = std::max(worst_.share, share);
    return error;
  }

  void Narrow(CosineSurface* curve) const {
    if (dropped_ == 0) return;
    for (CosineAcc* value : {&curve->a, &curve->b, &curve->c, &curve->d, &curve->e, &curve->f}) {
      const int64_t half = int64_t{1} << (dropped_ - 1);
      *value = CosineAcc::Wrap((value->raw() + half) >> dropped_ << dropped_);
    }
  }

  // Pixel k of the span, by one lane or by four.
  static LightCosines Shown(const TriangleState& triangle, const SpanCommand& span, int k,
                            const LightState& light) {
    const SpanSeed seed = SpanSetup::Seed(Method::kPhongSurface, triangle, span);
    if (span.x % 2 == 0) {
      PhongSurfaceShader<1> shader(seed.curve);
      for (int t = 0; t < k; ++t) shader.Step();
      return shader.At(0, light);
    }
    PhongSurfaceShader<kMaxLanes> shader(seed.curve);
    for (int t = 0; t < k / kMaxLanes; ++t) shader.Step();
    return shader.At(static_cast<size_t>(k % kMaxLanes), light);
  }

  // The surfaces' part of surface_fit.md: coefficients of |N|^2 and of the planes,
  // barycentrics, and the roundings of the cosines to 2^-31 at the corners and at the pixel.
  double Bound(double x, double y, double square) const {
    x = std::abs(x);
    const double root = std::sqrt(square);
    return (x * x + x * y + y * y + x + y + 1) * 0x1p-46 / square +
           (x + y + 1) * (0x1p-45 + 2 * std::sqrt(most_turn_) * 0x1p-34) / root + 0x1p-30 / root;
  }

  int size_;
  double least_turn_, most_turn_;
  int dropped_;
  std::mt19937 random_{7};
  std::vector<SpanCommand> spans_;
  Worst worst_;
};

const double kMostTurn = std::ldexp(double(MethodChoice::kSurfaceTurn), -Turn::kFraction);

TEST(PhongSurface, WithinErrorBound) {
  for (const auto& [size, bound] : {std::pair{2048, 3.1e-6}, {kMaxScreen, 8.2e-6}}) {
    const Search::Worst worst = Search(size, 0, kMostTurn).Run(60, 500);
    std::printf("%d pixels: %.3g, %.2f of the bound\n", size, worst.cosine, worst.share);
    EXPECT_LE(worst.share, 1);
    EXPECT_LE(worst.cosine, bound) << size;
    EXPECT_GT(worst.share, 0.4) << "the search is blind";
    EXPECT_GT(worst.triangles, 5000);
  }
}

TEST(PhongSurface, CoefficientsOfTwoBitsLessBreakTheBound) {
  const Search::Worst worst = Search(kMaxScreen, 0, kMostTurn, 2).Run(60, 500);
  std::printf("two bits less: %.2f of the bound\n", worst.share);
  EXPECT_GT(worst.share, 1);
}

// Beyond the turn that it is meant for the root of |N|^2 loses its digits.
TEST(PhongSurface, OpposedNormalsNeedPhongDuff) {
  const Search::Worst inside = Search(kMaxScreen, 0, kMostTurn).Run(30, 400);
  const Search::Worst beyond = Search(kMaxScreen, 3.9, 4).Run(30, 400);
  std::printf("inside %.3g, beyond %.3g\n", inside.cosine, beyond.cosine);
  EXPECT_GT(beyond.cosine, 10 * inside.cosine);
}

}  // namespace
}  // namespace shading
