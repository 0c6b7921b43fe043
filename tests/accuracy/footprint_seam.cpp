// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/footprint_seam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "model/footprint/footprint_setup.h"
#include "model/ideal/lighting.h"

namespace shading::accuracy {
namespace {

using ideal::Vector;
constexpr double kDegree = 3.14159265358979323846 / 180;
using Normals = std::array<Vector, 3>;

double Angle(const Vector& a, const Vector& b) {
  const Vector u = ideal::Normalised(a), v = ideal::Normalised(b);
  const Vector gap = ideal::Sum(u, ideal::Scaled(-1, v));
  return 2 * std::asin(std::min(1.0, std::sqrt(ideal::Dot(gap, gap)) / 2)) / kDegree;
}

// The vertices that the set-up folds the enlarged triangle into; screen positions do not matter.
Normals Folded(const Normals& n) {
  TrianglePacket packet;
  packet.x = {ScreenCoord::Round(10), ScreenCoord::Round(50), ScreenCoord::Round(20)};
  packet.y = {ScreenCoord::Round(10), ScreenCoord::Round(20), ScreenCoord::Round(60)};
  for (size_t i = 0; i < 3; ++i) {
    for (size_t c = 0; c < 3; ++c) packet.n[i][c] = NormalComponent::Round(n[i][c]);
  }
  FrameState frame;
  frame.width = frame.height = 64;
  frame.cull = Cull::kNone;
  frame.materials.resize(1);
  TriangleGeometry geometry;
  TriangleSetup::Setup(packet, frame, &geometry);
  FootprintSetup::Options options;
  options.form = FootprintForm::kPaper;
  const auto result = FootprintSetup(options).Of(packet, geometry, frame.materials[0], 0, 0);
  return {ideal::ToReal(result.vertex[0]), ideal::ToReal(result.vertex[1]),
          ideal::ToReal(result.vertex[2])};
}

Vector At(const Normals& n, double a, double b) {
  return ideal::Sum(ideal::Scaled(a, n[0]),
                    ideal::Sum(ideal::Scaled(b, n[1]), ideal::Scaled(1 - a - b, n[2])));
}

double Moved(const Normals& n) {
  constexpr int kGrid = 12;
  const Normals folded = Folded(n);
  double worst = 0;
  for (int i = 0; i <= kGrid; ++i) {
    for (int j = 0; i + j <= kGrid; ++j) {
      const double a = 1.0 * i / kGrid, b = 1.0 * j / kGrid;
      worst = std::max(worst, Angle(At(folded, a, b), At(n, a, b)));
    }
  }
  return worst;
}

// n[0], n[1] on the edge; n[2] on one side, other on the other. Both are numbered in the same turn.
double OnEdge(const Normals& n, const Vector& other) {
  const Normals left = Folded(n), right = Folded({n[1], n[0], other});
  double worst = 0;
  for (int i = 0; i <= 16; ++i) {
    const double w = i / 16.0;
    worst = std::max(worst, Angle(At(left, w, 1 - w), At(right, 1 - w, w)));
  }
  return worst;
}

// A unit normal at most `angle` degrees from the z axis, often exactly.
Vector Around(double angle, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const double away = angle * kDegree * (random() % 2 ? 1 : std::sqrt(uniform(random)));
  const double round = 360 * kDegree * uniform(random);
  return {std::sin(away) * std::cos(round), std::sin(away) * std::sin(round), std::cos(away)};
}

bool Within(const Normals& n, double spread) {
  return Angle(n[0], n[1]) <= spread && Angle(n[1], n[2]) <= spread && Angle(n[2], n[0]) <= spread;
}

// All three normals `spread` apart: a shape that random ones only approach.
Normals Equilateral(double spread) {
  const double away = std::asin(2 / std::sqrt(3) * std::sin(spread / 2 * kDegree));
  Normals n;
  for (size_t i = 0; i < 3; ++i) {
    const double round = 120 * kDegree * static_cast<double>(i);
    n[i] = {std::sin(away) * std::cos(round), std::sin(away) * std::sin(round), std::cos(away)};
  }
  return n;
}

// The mirror image of n[2] behind the edge of the others.
Vector Mirrored(const Normals& n) {
  const Vector edge = ideal::Normalised(ideal::Sum(n[0], n[1]));
  return ideal::Sum(ideal::Scaled(2 * ideal::Dot(edge, n[2]), edge), ideal::Scaled(-1, n[2]));
}

}  // namespace

SeamErrors SearchSeams(double spread, int trials) {
  std::mt19937 random(1);
  const double radius = spread / std::sqrt(3) * 1.05;  // of an equilateral triangle, and a little
  const Normals regular = Equilateral(spread);
  SeamErrors worst = {Moved(regular), OnEdge(regular, Mirrored(regular))};
  for (int i = 0; i < trials; ++i) {
    const Normals n = {Around(radius, random), Around(radius, random), Around(radius, random)};
    if (!Within(n, spread)) continue;
    worst.moved = std::max(worst.moved, Moved(n));
    const Vector other = Around(2 * radius, random);
    if (Within({n[0], n[1], other}, spread)) worst.edge = std::max(worst.edge, OnEdge(n, other));
  }
  return worst;
}

double LightChange(double degrees, int n) {
  double worst = 0;
  for (int i = 0; i < 9000; ++i) {
    const double from = i * 0.01 * kDegree;
    const double to = std::min(from + degrees * kDegree, 90 * kDegree);
    worst = std::max(worst, std::pow(std::cos(from), n) - std::pow(std::cos(to), n));
  }
  return 255 * worst;
}

}  // namespace shading::accuracy
