// SPDX-License-Identifier: Apache-2.0
#include "model/ideal/footprint.h"

#include <algorithm>
#include <cmath>

namespace shading::ideal {
namespace {

constexpr double kPi = 3.14159265358979323846;

// Mean light over points of equal area; normal(x, y) is nullopt where a point does not count.
template <typename NormalOf>
Rgb MeanOverDisc(const Light& light, const Material& material, double x, double y,
                 const NormalOf& normal) {
  Rgb sum = {};
  int count = 0;
  for (int ring = 0; ring < Footprint::kRings; ++ring) {
    const double radius = Footprint::kRadius * std::sqrt((ring + 0.5) / Footprint::kRings);
    for (int spoke = 0; spoke < Footprint::kSpokes; ++spoke) {
      // Odd rings turn by half a spoke.
      const double angle = 2 * kPi * (spoke + 0.5 * (ring % 2)) / Footprint::kSpokes;
      const std::optional<Vector> n =
          normal(x + radius * std::cos(angle), y + radius * std::sin(angle));
      if (!n) continue;
      Light::Cosines cosines = light.CosinesOf(Normalised(*n));
      const Light::Terms terms = light.TermsOf(cosines, material);
      cosines.n_dot_l = std::clamp(cosines.n_dot_l, 0.0, 1.0);
      const Light::Terms lit = light.TermsOf(cosines, material);
      sum = Sum(sum, Sum(lit.diffuse, terms.specular));
      ++count;
    }
  }
  const Rgb mean = count ? Scaled(1.0 / count, sum) : Rgb{};
  return Clamped(Sum(light.TermsOf({}, material).ambient, mean));
}

Vector Weighted(const Barycentric::Weights& weight, const std::array<Vector, 3>& normal) {
  return Sum(Scaled(weight[0], normal[0]),
             Sum(Scaled(weight[1], normal[1]), Scaled(weight[2], normal[2])));
}

}  // namespace

Footprint::Footprint(const FrameState& frame, const TrianglePacket& triangle,
                     const Distances& distances)
    : barycentric_(triangle), light_(frame), material_(MaterialOf(frame, triangle)) {
  for (size_t i = 0; i < 3; ++i) {
    normal_[i] = ToReal(triangle.n[i]);
    if (distances) normal_[i] = Scaled(1 / (*distances)[i], normal_[i]);
  }
}

Vector Footprint::Normal(double x, double y) const {
  return Weighted(barycentric_.At(x, y), normal_);
}

Rgb Footprint::At(double x, double y) const {
  return MeanOverDisc(light_, material_, x, y,
                      [this](double u, double v) { return std::optional<Vector>(Normal(u, v)); });
}

PaperFootprint::PaperFootprint(const FrameState& frame, const TrianglePacket& triangle)
    : light_(frame), material_(MaterialOf(frame, triangle)) {
  for (size_t i = 0; i < 3; ++i) {
    const size_t before = (i + 2) % 3;
    x_[i] = 2 * triangle.x[i].ToReal() - triangle.x[before].ToReal();
    y_[i] = 2 * triangle.y[i].ToReal() - triangle.y[before].ToReal();
    const Vector at = ToReal(triangle.n[i]), from = ToReal(triangle.n[before]);
    normal_[i] = Sum(Scaled(2 * Dot(from, at), at), Scaled(-1, from));
  }
}

Barycentric::Weights PaperFootprint::Weights(double x, double y) const {
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
  return MeanOverDisc(light_, material_, x, y, [this](double u, double v) {
    return Outside(u, v) ? std::nullopt : std::optional<Vector>(Normal(u, v));
  });
}

}  // namespace shading::ideal
