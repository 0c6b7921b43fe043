// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/choice_search.h"

#include <algorithm>
#include <cmath>

namespace shading::accuracy {
namespace {

using ideal::Dot;
using ideal::Normalised;
using ideal::Scaled;
using ideal::Sum;
using ideal::Vector;

constexpr double kPi = 3.14159265358979323846;

}  // namespace

// Normals 0 and 1 are `chord` apart. Normal 2 is `near` of that angle from 0, and from 1 as far as
// `apart` says, between the least and the most that there can be.
ChoiceCase ChoicePoint::Case() const {
  const double spread = 2 * std::asin(chord / 2), b = spread * near;
  const double c = spread - b + apart * b;
  const double sines = std::sin(spread) * std::sin(b);
  const double cosine = sines > 0 ? (std::cos(c) - std::cos(spread) * std::cos(b)) / sines : 1;
  const double turn = std::acos(std::clamp(cosine, -1.0, 1.0));
  ChoiceCase at;
  at.normal = {Vector{0, 0, 1}, Vector{std::sin(spread), 0, std::cos(spread)},
               Vector{std::sin(b) * std::cos(turn), std::sin(b) * std::sin(turn), std::cos(b)}};
  at.light = light;
  at.half_or_view = half_or_view;
  at.end = end;
  at.along = along;
  return at;
}

// In proportion to the logarithm.
double ChoiceSearch::Between(double least, double most) {
  return least * std::exp(Uniform() * std::log(most / least));
}

Vector ChoiceSearch::Aside(const Vector& v, double angle) {
  return Normalised(Sum(v, Vector{angle * Gauss(), angle * Gauss(), angle * Gauss()}));
}

std::array<double, 3> ChoiceSearch::RandomWeight(bool edge) {
  const double u = Uniform(), v = Uniform();
  std::array<double, 3> weight = {std::min(u, v), std::max(u, v) - std::min(u, v),
                                  1 - std::max(u, v)};
  if (edge || random_() % 2 == 0) weight = {u, 1 - u, 0};
  if (!edge && random_() % 3 == 0)
    std::rotate(&weight[0], &weight[1 + random_() % 2], &weight[0] + 3);
  return weight;
}

ChoicePoint ChoiceSearch::Start(const ChoiceRegion& region) {
  ChoicePoint point;
  point.chord = Between(region.least_chord, region.most_chord);
  point.shininess = Between(region.least_shininess, region.most_shininess);
  const auto shape = random_() % 4;
  if (shape == 1) point.near = Uniform(), point.apart = Uniform();
  if (shape == 2) point.near = std::round(2 * Uniform()) / 2, point.apart = std::round(Uniform());
  if (shape == 3) point.near = 0.9 + 0.1 * Uniform(), point.apart = Uniform();
  point.edge = region.edge;
  const auto turn = static_cast<int>(random_() % 3);
  for (auto& end : point.end) {
    end = RandomWeight(region.edge);
    if (region.edge) std::rotate(end.begin(), end.begin() + turn, end.end());
  }
  point.along = Uniform();
  const auto normal = point.Case().normal;
  const auto above = [&] {
    const auto weight = RandomWeight(false);
    Vector sum = {};
    for (size_t i = 0; i < 3; ++i) sum = Sum(sum, Scaled(weight[i], normal[i]));
    return Normalised(sum);
  };
  // Off a point of the triangle by the angle where the highlight is so faint.
  const double faint = std::min(1.0, (region.highlight + Uniform()) / 1.4427 / point.shininess);
  const double angle = std::acos(1 - faint) + (random_() % 2 == 0 ? 0 : point.chord * Uniform());
  const Vector base = above();
  const Vector any = Aside({}, 1);
  const Vector level = Normalised(Sum(any, Scaled(-Dot(any, base), base)));
  const Vector half = Sum(Scaled(std::cos(angle), base), Scaled(std::sin(angle), level));
  const auto kind = random_() % 3;
  point.light = kind == 0 ? Aside(above(), point.chord) : kind == 1 ? Aside({}, 1) : level;
  point.half_or_view = half;
  if (region.reflected) {
    const Vector off = Scaled(std::tan(Uniform() * 1.3), Normalised(Aside({}, 1)));
    point.light = Normalised(Sum(half, off));
    point.half_or_view =
        Normalised(Sum(Scaled(2 * Dot(point.light, half), half), Scaled(-1, point.light)));
    // R.V turns twice as far.
    const Vector nearer =
        Sum(Scaled(std::cos(angle / 2), base), Scaled(std::sin(angle / 2), level));
    if (random_() % 2 == 0) {
      const Vector l = Normalised(Sum(nearer, off));
      point.half_or_view = Normalised(Sum(Scaled(2 * Dot(l, nearer), nearer), Scaled(-1, l)));
      point.light = l;
    }
  }
  return point;
}

void ChoiceSearch::MoveWeight(std::array<double, 3>* weight, double scale, bool edge) {
  double sum = 0;
  for (double& w : *weight) {
    if (!edge || w > 0) w = std::clamp(w + scale * Gauss(), edge ? 1e-9 : 0.0, 1.0);
    sum += w;
  }
  for (double& w : *weight) w = sum > 0 ? w / sum : 1.0 / 3;
}

ChoicePoint ChoiceSearch::Neighbor(ChoicePoint point, const ChoiceRegion& region, double scale) {
  const auto moves = [&] { return random_() % 3 != 0; };
  if (moves()) {
    point.near = std::clamp(point.near + scale * Gauss(), 0.0, 1.0);
    point.apart = std::clamp(point.apart + scale * Gauss(), 0.0, 1.0);
  }
  if (moves()) {
    point.chord =
        std::clamp(point.chord * std::exp(scale * Gauss()), region.least_chord, region.most_chord);
  }
  if (moves()) {
    point.shininess = std::clamp(point.shininess * std::exp(scale * Gauss()),
                                 region.least_shininess, region.most_shininess);
  }
  const double width = std::min(kPi / 2, 2 / std::sqrt(point.shininess));
  if (moves()) point.half_or_view = Aside(point.half_or_view, scale * width);
  if (moves()) point.light = Aside(point.light, scale * (region.reflected ? width : kPi / 2));
  if (moves()) {
    for (auto& end : point.end) MoveWeight(&end, scale, region.edge);
    point.along = std::clamp(point.along + scale * Gauss(), 0.0, 1.0);
  }
  return point;
}

ChoiceSearch::Found ChoiceSearch::Run(const ChoiceRegion& region, const Objective& objective,
                                      int restarts, int steps) {
  Found worst;
  for (int restart = 0; restart < restarts; ++restart) {
    Found best;
    for (int i = 0; i < 20; ++i) {
      const ChoicePoint point = Start(region);
      const double value = objective(point);
      if (i == 0 || value > best.value) best = {value, point};
    }
    double scale = 0.2;
    for (int i = 0; i < steps; ++i) {
      const ChoicePoint point = Neighbor(best.point, region, scale);
      const double value = objective(point);
      const bool better = value > best.value;
      scale = std::clamp(scale * (better ? 1.6 : 0.88), 1e-6, 0.5);
      if (better) best = {value, point};
    }
    if (restart == 0 || best.value > worst.value) worst = best;
  }
  return worst;
}

}  // namespace shading::accuracy
