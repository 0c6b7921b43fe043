// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/footprint.h"

#include <algorithm>
#include <cmath>

namespace shading::ideal {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Mean light; normal(x, y) is nullopt where a point does not count.
template <typename NormalOf>
Rgb MeanOverDisc(const Light& light, const Material& material, const Disc::Points& points, double x,
                 double y, const NormalOf& normal) {
  Rgb sum = {};
  int count = 0;
  for (const auto& [dx, dy] : points) {
    const std::optional<Vector> n = normal(x + dx, y + dy);
    if (!n) continue;
    const Light::Terms terms = light.LitTermsOf(light.CosinesOf(Normalised(*n)), material);
    sum = Sum(sum, Sum(terms.diffuse, terms.specular));
    ++count;
  }
  const Rgb mean = count ? Scaled(1.0 / count, sum) : Rgb{};
  return Clamped(Sum(light.TermsOf({}, material).ambient, mean));
}

Vector Weighted(const Barycentric::Weights& weight, const std::array<Vector, 3>& normal) {
  return Sum(Scaled(weight[0], normal[0]),
             Sum(Scaled(weight[1], normal[1]), Scaled(weight[2], normal[2])));
}

}  // namespace

Disc Disc::Within(const TrianglePacket& triangle, int rings) {
  const auto x = [&](size_t i) { return triangle.x[i].ToReal(); };
  const auto y = [&](size_t i) { return triangle.y[i].ToReal(); };
  double longest = 0;
  for (size_t i = 0; i < 3; ++i) {
    const size_t j = (i + 1) % 3;
    longest = std::max(longest, std::hypot(x(j) - x(i), y(j) - y(i)));
  }
  const double area = std::abs((x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0)));
  return {std::min(kPixel, area / longest / 2), rings};
}

Disc::Points Disc::Offsets() const {
  Points points;
  points.reserve(static_cast<size_t>(rings * rings));
  for (int ring = 0; ring < rings; ++ring) {
    const double reach = radius * std::sqrt((ring + 0.5) / rings);
    for (int spoke = 0; spoke < rings; ++spoke) {
      // Odd rings turn by half a spoke.
      const double angle = 2 * kPi * (spoke + 0.5 * (ring % 2)) / rings;
      points.push_back({reach * std::cos(angle), reach * std::sin(angle)});
    }
  }
  return points;
}

Footprint::Footprint(const FrameState& frame, const TrianglePacket& triangle,
                     const Distances& distances, const Disc& disc)
    : points_(disc.Offsets()),
      barycentric_(triangle),
      light_(frame),
      material_(MaterialOf(frame, triangle)) {
  for (size_t i = 0; i < 3; ++i) {
    normal_[i] = ToReal(triangle.n[i]);
    if (distances) normal_[i] = Scaled(1 / (*distances)[i], normal_[i]);
  }
}

Vector Footprint::Normal(double x, double y) const {
  return Weighted(barycentric_.At(x, y), normal_);
}

Rgb Footprint::At(double x, double y) const {
  return MeanOverDisc(light_, material_, points_, x, y,
                      [this](double u, double v) { return std::optional<Vector>(Normal(u, v)); });
}

Rgb QuadraticFootprint::At(double x, double y) const {
  Rgb sum = {};
  for (const auto& [dx, dy] : points_) sum = Sum(sum, quadratic_.AtUnclamped(x + dx, y + dy));
  return Clamped(Scaled(1.0 / static_cast<double>(points_.size()), sum));
}

// On the surface: enlarging a triangle is the same in every affine picture of it.
PaperFootprint::PaperFootprint(const FrameState& frame, const TrianglePacket& triangle,
                               const Footprint::Distances& distances, const Disc& disc)
    : points_(disc.Offsets()),
      barycentric_(triangle),
      light_(frame),
      material_(MaterialOf(frame, triangle)) {
  constexpr std::array<double, 3> kX = {0, 1, 0}, kY = {0, 0, 1};
  for (size_t i = 0; i < 3; ++i) {
    const size_t before = (i + 2) % 3;
    near_[i] = distances ? 1 / (*distances)[i] : 1;
    x_[i] = 2 * kX[i] - kX[before];
    y_[i] = 2 * kY[i] - kY[before];
    const Vector at = ToReal(triangle.n[i]), from = ToReal(triangle.n[before]);
    normal_[i] = Sum(Scaled(2 * Dot(from, at), at), Scaled(-1, from));
  }
}

Barycentric::Weights PaperFootprint::Weights(double column, double row) const {
  Barycentric::Weights at = barycentric_.At(column, row);
  for (size_t i = 0; i < 3; ++i) at[i] *= near_[i];
  const double sum = at[0] + at[1] + at[2], x = at[1] / sum, y = at[2] / sum;
  const auto area = [&](size_t a, size_t b) {
    return (x_[a] - x) * (y_[b] - y) - (x_[b] - x) * (y_[a] - y);
  };
  const double whole = (x_[1] - x_[0]) * (y_[2] - y_[0]) - (x_[2] - x_[0]) * (y_[1] - y_[0]);
  return {area(1, 2) / whole, area(2, 0) / whole, area(0, 1) / whole};
}

Vector PaperFootprint::Normal(double x, double y) const { return Weighted(Weights(x, y), normal_); }

bool PaperFootprint::Outside(double x, double y) const {
  const Barycentric::Weights c = Weights(x, y);
  return std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]) > 1 + 1e-9;
}

bool PaperFootprint::Subdivides() const {
  return Dot(normal_[0], normal_[1]) < 0 || Dot(normal_[1], normal_[2]) < 0 ||
         Dot(normal_[2], normal_[0]) < 0;
}

Rgb PaperFootprint::At(double x, double y) const {
  return MeanOverDisc(light_, material_, points_, x, y, [this](double u, double v) {
    return Outside(u, v) ? std::nullopt : std::optional<Vector>(Normal(u, v));
  });
}

}  // namespace shading::ideal
