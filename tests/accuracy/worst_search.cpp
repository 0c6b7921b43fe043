// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/worst_search.h"

#include <algorithm>
#include <cmath>

#include "model/light/specular_cosine.h"

namespace shading::accuracy {
namespace {

constexpr double kPi = 3.14159265358979323846;

using Axes = std::array<Direction, 3>;

Axes AxesOf(const std::array<double, 4>& quaternion) {
  double square = 0;
  for (const double q : quaternion) square += q * q;
  const double scale = 1 / std::sqrt(square);
  const double w = quaternion[0] * scale, x = quaternion[1] * scale, y = quaternion[2] * scale,
               z = quaternion[3] * scale;
  return {Direction{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
          Direction{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
          Direction{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

// Takes the first axis to (1, 1, 1) after a turn about itself.
std::array<double, 4> DiagonalFrame(double turn) {
  const double half = std::acos(1 / std::sqrt(3.0)) / 2;
  const double a = std::cos(half), b = std::sin(half) / std::sqrt(2.0);
  const double c = std::cos(turn / 2), s = std::sin(turn / 2);
  return {a * c, a * s, b * (s - c), b * (s + c)};
}

template <typename Vector>
Vector Rounded(const Direction& v) {
  Vector result;
  for (size_t c = 0; c < 3; ++c) {
    result[c] = Vector::value_type::Round(static_cast<double>(v[c]));
  }
  return result;
}

Shininess ShininessOf(int n) { return Shininess::FromRaw(n << Shininess::kFraction); }

}  // namespace

WorstSearch::WorstSearch(const Cell& cell)
    : cell_(cell),
      power_(ShininessOf(cell.shininess)),
      width_(cell.shininess == 1 ? kPi / 2 : std::acos(std::sqrt(1 - 1.0 / cell.shininess))) {}

Worst WorstSearch::Evaluate(const SpanCase& span) {
  ModelCosines(cell_.configuration, span, &cosines_);
  if (span.normal != ideal_ends_) {
    ideal_.Set(cell_.ideal, span.normal, span.length);
    ideal_ends_ = span.normal;
  }
  const IdealSpan::Row row = ideal_.Cosines(span.direction);
  const bool diffuse = cell_.shininess == 1;
  Real most = -1;
  size_t pixel = 0;
  for (size_t t = 0; t < cosines_.size(); ++t) {
    const double got = diffuse ? SpecularCosine::DiffuseOf(cosines_[t]).ToReal()
                               : power_.Of(cosines_[t].n_dot_h_or_v).ToReal();
    const Real error = std::abs(got - IdealIntensity(row.At(t), cell_.shininess));
    if (error > most) {
      most = error;
      pixel = t;
    }
  }
  return {static_cast<double>(255 * most), static_cast<int>(pixel), span};
}

// Ranges of angles are searched evenly in the logarithm, in degrees, from their end, and where the
// bend of a step falls just short of half an ulp of S1.38 and is lost. Adaptive methods err most
// where an angle falls just short of another level.
double WorstSearch::StartAngle(int restart) {
  const double range = cell_.degrees / cell_.least_degrees;
  const double part = Uniform();
  if (IsAdaptive(cell_.configuration.method) && restart % 2 == 1) {
    const double limit = std::ldexp(static_cast<double>(cell_.configuration.limit.raw()), -30);
    const double segment = (1 - 1e-4 * part) * std::acos(1 - limit) * 180 / kPi;
    const double degrees = std::ldexp(segment, static_cast<int>(10 * Uniform()));
    return std::clamp(std::log(degrees / cell_.least_degrees) / std::log(range), 0.0, 1.0);
  }
  switch (restart % 5) {
    case 1: return std::log(1 + (range - 1) * part) / std::log(range);
    case 2: {
      const double step = std::sqrt(std::ldexp(1 + 0.8 * part, -39)) / cell_.configuration.lanes;
      const double degrees = (cell_.length - 1) * step * 180 / kPi;
      return std::clamp(std::log(degrees / cell_.least_degrees) / std::log(range), 0.0, 1.0);
    }
    case 4: return 1;
    default: return part;
  }
}

// Restarts take turns: light at the peak, on the steepest slope or anywhere up to three times as
// far; in the plane of the arc, across it or anywhere; seen from either end, the middle or
// anywhere; arcs anywhere, in a plane of the axes, or from the direction (1, 1, 1), where three
// equal components round alike.
WorstSearch::Point WorstSearch::Start(int restart) {
  Point point;
  for (double& q : point.frame) q = Normal();
  if (restart % 4 == 3) point.frame = {1, std::round(Uniform()), std::round(Uniform()), 0};
  if (restart % 4 == 1) point.frame = DiagonalFrame(2 * kPi * Uniform());
  point.angle = StartAngle(restart);
  const double far = width_ * (cell_.shininess == 1 ? 1 : 3) * Uniform();
  point.tilt = std::array<double, 3>{width_, far, 0.01 * width_}[static_cast<size_t>(restart) % 3];
  const std::array<double, 3> azimuth = {std::round(Uniform()) * kPi,
                                         (std::round(Uniform()) - 0.5) * kPi, 2 * kPi * Uniform()};
  point.azimuth = azimuth[static_cast<size_t>(Uniform() * 3)];
  const std::array<double, 4> place = {0, 0.5, 1, Uniform()};
  point.place = place[static_cast<size_t>(Uniform() * 4)];
  return point;
}

WorstSearch::Point WorstSearch::Neighbor(Point point, double scale, bool turn_arc) {
  if (turn_arc) {
    for (double& q : point.frame) q += scale * Normal();
    point.angle = std::clamp(point.angle + scale * Normal(), 0.0, 1.0);
  }
  point.place = std::clamp(point.place + scale * Normal(), 0.0, 1.0);
  point.tilt += scale * width_ * Normal();
  point.azimuth += scale * kPi * Normal();
  return point;
}

SpanCase WorstSearch::SpanOf(const Point& point) const {
  const Axes axes = AxesOf(point.frame);
  const double degrees =
      cell_.least_degrees * std::pow(cell_.degrees / cell_.least_degrees, point.angle);
  const double psi = degrees * kPi / 180;
  const auto at = [&](double angle) {
    return Combination(std::cos(angle), axes[0], std::sin(angle), axes[1]);
  };
  const double seen = psi * point.place;
  const Direction aside =
      Combination(std::cos(point.azimuth), at(seen + kPi / 2), std::sin(point.azimuth), axes[2]);
  SpanCase span;
  span.length = cell_.length;
  span.normal = {Rounded<SpanNormal>(at(0)), Rounded<SpanNormal>(at(psi))};
  span.direction = Rounded<Vector3>(
      Unit(Combination(std::cos(point.tilt), at(seen), std::sin(point.tilt), aside)));
  return span;
}

Worst WorstSearch::Run(const Effort& effort, unsigned seed) {
  random_.seed(seed);
  Worst worst;
  for (int restart = 0; restart < effort.restarts; ++restart) {
    Point best_point = {};
    Worst best;
    for (int i = 0; i < effort.starts; ++i) {
      const Point point = Start(restart);
      const Worst found = Evaluate(SpanOf(point));
      if (i == 0 || found.lsb > best.lsb) {
        best = found;
        best_point = point;
      }
    }
    double scale = 0.1;
    for (int i = 0; i < effort.steps; ++i) {
      const Point point = Neighbor(best_point, scale, i % 2 == 0);
      const Worst found = Evaluate(SpanOf(point));
      scale *= found.lsb > best.lsb ? 1.5 : 0.87;
      if (found.lsb <= best.lsb) continue;
      best = found;
      best_point = point;
    }
    if (best.lsb > worst.lsb) worst = best;
  }
  return worst;
}

}  // namespace shading::accuracy
