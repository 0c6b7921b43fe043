// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/spread_search.h"

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

// Turned towards the triangle until no corner looks away: nearly, where that takes several turns.
Vector TurnedToCorners(Vector light, const std::array<Vector, 3>& normals) {
  for (int turn = 0; turn < 3; ++turn) {
    for (const Vector& normal : normals) {
      const double cosine = Dot(normal, light);
      if (cosine < 0) light = Sum(light, Scaled(-(1 + 1e-9) * cosine, normal));
    }
  }
  return Normalised(light);
}

// The linear normal.
Vector Over(const std::array<Vector, 3>& normals, const std::array<double, 3>& weight) {
  Vector sum = {};
  for (size_t i = 0; i < 3; ++i) sum = Sum(sum, Scaled(weight[i], normals[i]));
  return Normalised(sum);
}

}  // namespace

SpreadSearch::SpreadSearch(Method method, const SpreadLight& light, double degrees)
    : method_(method),
      light_(light),
      spread_(degrees * kPi / 180),
      width_(light.shininess == 1 ? kPi / 2 : std::acos(std::sqrt(1 - 1.0 / light.shininess))) {}

std::array<Vector, 3> SpreadSearch::NormalsOf(const Point& point) const {
  const double b = spread_ * point.near;
  const double most = std::min(spread_, 2 * kPi - spread_ - b);
  const double c = spread_ - b + point.apart * (most - (spread_ - b));
  // The angle at normal 0, of the spherical triangle with the sides spread, b and c.
  const double sines = std::sin(spread_) * std::sin(b);
  const double cosine = sines > 0 ? (std::cos(c) - std::cos(spread_) * std::cos(b)) / sines : 1;
  const double turn = std::acos(std::clamp(cosine, -1.0, 1.0));
  return {Vector{0, 0, 1}, Vector{std::sin(spread_), 0, std::cos(spread_)},
          Vector{std::sin(b) * std::cos(turn), std::sin(b) * std::sin(turn), std::cos(b)}};
}

Vector SpreadSearch::Aside(const Vector& v, double angle) {
  return Normalised(Sum(v, Vector{angle * Gauss(), angle * Gauss(), angle * Gauss()}));
}

std::array<double, 3> SpreadSearch::RandomWeight() {
  const double u = Uniform(), v = Uniform();
  return {std::min(u, v), std::max(u, v) - std::min(u, v), 1 - std::max(u, v)};
}

// Restarts take turns: an equilateral triangle, one with two normals alike or in line, or any; H
// over a point of the triangle, off by up to the highlight's steepest slope, or up to three times
// as far; L over the triangle, level with it at the point, or anywhere; the point in the middle, on
// an edge, or anywhere.
SpreadSearch::Point SpreadSearch::Start(int restart) {
  Point point;
  if (restart % 3 == 1) {
    point.near = Uniform();
    point.apart = Uniform();
  } else if (restart % 3 == 2) {
    point.near = std::round(2 * Uniform()) / 2;
    point.apart = std::round(Uniform());
  }
  point.weight = RandomWeight();
  if (restart % 5 == 1) point.weight = {1.0 / 3, 1.0 / 3, 1.0 / 3};
  if (restart % 5 == 2) {
    const double w = Uniform();
    point.weight = {w, 1 - w, 0};
    std::shuffle(point.weight.begin(), point.weight.end(), random_);
  }
  const auto normals = NormalsOf(point);
  const Vector above = Over(normals, RandomWeight()), here = Over(normals, point.weight);
  const double far = std::max(width_, spread_);
  point.half = Aside(above, restart % 2 == 0 ? width_ : 3 * far * Uniform());
  const Vector any = Aside({}, 1);
  const Vector level = Normalised(Sum(any, Scaled(-Dot(any, here), here)));
  point.light = std::array<Vector, 3>{Aside(above, spread_), level,
                                      any}[static_cast<size_t>(restart / 3) % 3];
  return point;
}

SpreadSearch::Point SpreadSearch::Neighbor(Point point, double scale) {
  const auto move = [&](double value) { return std::clamp(value + scale * Gauss(), 0.0, 1.0); };
  const unsigned kept = random_() % 4;  // one of four parts stays as it is
  if (kept != 0) {
    point.near = move(point.near);
    point.apart = move(point.apart);
  }
  if (kept != 1) point.half = Aside(point.half, scale * std::min(2 * width_, kPi / 2));
  if (kept != 2) point.light = Aside(point.light, scale * kPi / 2);
  if (kept != 3) {
    double sum = 0;
    for (double& w : point.weight) sum += w = move(w);
    for (double& w : point.weight) w = sum > 0 ? w / sum : 1.0 / 3;
  }
  return point;
}

SpreadCase SpreadSearch::CaseOf(const Point& point) const {
  SpreadCase at;
  at.normal = NormalsOf(point);
  at.light = light_.lit ? TurnedToCorners(point.light, at.normal) : point.light;
  at.half = light_.lit ? TurnedToCorners(point.half, at.normal) : point.half;
  at.weight = point.weight;
  return at;
}

SpreadSearch::Found SpreadSearch::Evaluate(const Point& point) const {
  return {SpreadError(method_, light_, CaseOf(point)), point};
}

SpreadSearch::Found SpreadSearch::Climb(Found best, int steps) {
  double scale = 0.2;
  for (int i = 0; i < steps; ++i) {
    const Found found = Evaluate(Neighbor(best.point, scale));
    const bool better = found.error > best.error;
    scale = std::clamp(scale * (better ? 1.6 : 0.88), 1e-7, 0.5);
    if (better) best = found;
  }
  return best;
}

SpreadWorst SpreadSearch::Run(const SpreadEffort& effort, unsigned seed) {
  random_.seed(seed);
  Found worst;
  for (int restart = 0; restart < effort.restarts; ++restart) {
    Found best;
    for (int i = 0; i < effort.starts; ++i) {
      const Found found = Evaluate(Start(restart));
      if (i == 0 || found.error > best.error) best = found;
    }
    best = Climb(best, effort.steps);
    if (best.error > worst.error) worst = best;
  }
  for (int i = 0; i < 4; ++i) worst = Climb(worst, 2 * effort.steps);
  return {worst.error, CaseOf(worst.point)};
}

double SearchedError(Method method, const SpreadLight& light, double degrees,
                     const SpreadEffort& effort) {
  return SpreadSearch(method, light, degrees).Run(effort).error;
}

// By secants of the logarithms: the error is nearly a power of the spread.
double SearchedLimit(Method method, const SpreadLight& light, double codes,
                     const SpreadEffort& effort) {
  constexpr double kMost = 120;
  const auto excess = [&](double degrees) {
    return std::log(SearchedError(method, light, degrees, effort) / codes);
  };
  double degrees = 10, power = 3;
  double error = excess(degrees);
  for (int i = 0; i < 12 && std::abs(error) > 1e-3; ++i) {
    const double next = std::min(degrees * std::exp(std::clamp(-error / power, -2.0, 1.0)), kMost);
    if (next == degrees) break;
    const double next_error = excess(next);
    power = std::clamp((next_error - error) / std::log(next / degrees), 1.0, 6.0);
    degrees = next;
    error = next_error;
  }
  return degrees;
}

}  // namespace shading::accuracy
