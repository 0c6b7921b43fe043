// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/footprint_raster.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/footprint/footprint_light.h"
#include "model/ideal/footprint.h"
#include "model/normal/linear_recurrence.h"
#include "model/normal/normal_setup.h"
#include "model/normal/span_normals.h"
#include "model/raster/span_walker.h"

namespace shading::accuracy {
namespace {

using ideal::Vector;
constexpr double kPi = 3.14159265358979323846;
constexpr double kSize = 12;  // pixels

Vector Cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector3 Quantised(const Vector& v) {
  const Vector unit = ideal::Normalised(v);
  return {NormalComponent::Round(unit[0]), NormalComponent::Round(unit[1]),
          NormalComponent::Round(unit[2])};
}

struct Drawn {
  TrianglePacket packet;
  ideal::Footprint::Distances distances;
  VertexWeights weights = kNoPerspective;
};

// A triangle around the middle of a plane whose normal turns evenly on it, seen at a slant in a
// random direction.
Drawn DrawTriangle(const RasterCase& c, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  const double tilt = kPi * uniform(random), cosine = 1 / c.ratio;
  const Vector n = {std::sqrt(1 - cosine * cosine) * std::cos(tilt),
                    std::sqrt(1 - cosine * cosine) * std::sin(tilt), cosine};
  const Vector v = {-std::sin(tilt), std::cos(tilt), 0}, u = Cross(v, n);
  const double curvature = c.turn * kPi / 180 * cosine / ideal::Footprint::kRadius;  // rad a pixel
  Drawn drawn;
  std::array<double, 3> distance;
  const double phase = kPi * uniform(random);
  for (size_t i = 0; i < 3; ++i) {
    const double angle = phase + 2 * kPi / 3 * (static_cast<double>(i) + 0.3 * uniform(random));
    const double s = kSize / 2 * std::cos(angle) / cosine, t = kSize / 2 * std::sin(angle);
    const Vector p = ideal::Sum(ideal::Scaled(s, u), ideal::Scaled(t, v));
    distance[i] = 1 - (c.perspective ? 0.3 * p[2] / (kSize * c.ratio) : 0);
    drawn.packet.x[i] = ScreenCoord::Round(32 + p[0] / distance[i]);
    drawn.packet.y[i] = ScreenCoord::Round(32 + p[1] / distance[i]);
    drawn.packet.n[i] =
        Quantised(ideal::Sum(n, ideal::Sum(ideal::Scaled(std::tan(curvature * s), u),
                                           ideal::Scaled(std::tan(curvature * t), v))));
  }
  if (!c.perspective) return drawn;
  drawn.distances = distance;
  const double nearest = *std::min_element(distance.begin(), distance.end());
  for (size_t i = 0; i < 3; ++i) {
    drawn.weights[i] = std::llround((1 << NormalComponent::kFraction) * nearest / distance[i]);
  }
  return drawn;
}

FrameState FrameFor(const RasterCase& c, const TrianglePacket& packet, std::mt19937& random) {
  std::normal_distribution<double> gauss(0, 1 / std::sqrt(c.shininess));
  FrameState frame;
  frame.width = frame.height = 64;
  frame.cull = Cull::kNone;
  const Vector middle =
      ideal::Sum(ideal::ToReal(packet.n[0]),
                 ideal::Sum(ideal::ToReal(packet.n[1]), ideal::ToReal(packet.n[2])));
  frame.half = Quantised(
      ideal::Sum(ideal::Normalised(middle), {gauss(random), gauss(random), gauss(random)}));
  Material material;
  material.specular = {Reflectance::Round(1), Reflectance::Round(1), Reflectance::Round(1)};
  material.shininess = Shininess::Round(c.shininess);
  frame.materials = {material};
  return frame;
}

// The highlight of every pixel by the units, row by row.
template <typename Visit>
void ShadeTriangle(const FrameState& frame, const TrianglePacket& packet,
                   const TriangleGeometry& geometry, const FootprintSetup::Result& setup,
                   const Visit& visit) {
  TrianglePacket folded = packet;
  folded.n = setup.vertex;
  std::vector<SpanCommand> spans;
  SpanWalker::Walk(geometry, TriangleSetup::DepthPlane(geometry, packet), &spans);
  if (spans.empty()) return;
  SpanNormals::Attach(geometry, folded, SpanNormals::Interpolation::kLinear, 0, {}, &spans);
  FootprintLight light(LightOf(frame));
  light.SetMaterial(frame.materials[0]);
  for (const SpanCommand& span : spans) {
    NormalSeed seed;
    NormalSetup::Seed({}, {}, span, 1, &seed);
    std::array<LinearRecurrence, 3> line;
    for (size_t c = 0; c < 3; ++c) line[c] = LinearRecurrence(seed.quantity[c][0]);
    AnisoFootprint samples(setup.footprint,
                           setup.At(span.x - geometry.box_x, span.y - geometry.box_y), 0, 1);
    for (int x = span.x; x < span.x + span.length; ++x) {
      const std::array<Quantity, 3> centre = {line[0].value(), line[1].value(), line[2].value()};
      AnisoFootprint counted = samples;
      int taken = 0;
      const int count = SampleCount(setup.footprint.pattern);
      for (int i = 0; i < count; ++i) taken += counted.Next(i, centre).live;
      visit(x, span.y, light.Mean(setup.footprint.pattern, centre, &samples).highlight.ToReal(),
            taken);
      samples.Step();
      for (LinearRecurrence& l : line) l.Step();
    }
  }
}

}  // namespace

RasterErrors ErrorsOnTriangles(const RasterCase& c, const FootprintSetup::Options& options,
                               int triangles) {
  std::mt19937 random(1);
  FootprintSetup::Options given = options;
  given.form = c.form;
  const FootprintSetup setup(given);
  RasterErrors total;
  for (int i = 0; i < triangles; ++i) {
    const Drawn drawn = DrawTriangle(c, random);
    const FrameState frame = FrameFor(c, drawn.packet, random);
    TriangleGeometry geometry;
    if (TriangleSetup::Setup(drawn.packet, frame, &geometry) != Verdict::kDraw) continue;
    const FootprintSetup::Result result = setup.Of(drawn.packet, geometry, frame.materials[0],
                                                   geometry.box_x, geometry.box_y, drawn.weights);
    const ideal::Footprint seamless(frame, drawn.packet, drawn.distances);
    const ideal::PaperFootprint paper(frame, drawn.packet);
    ShadeTriangle(frame, drawn.packet, geometry, result, [&](int x, int y, double unit, int taken) {
      const ideal::Rgb ideal = c.form == FootprintForm::kPaper ? paper.At(x + 0.5, y + 0.5)
                                                               : seamless.At(x + 0.5, y + 0.5);
      const double error = std::abs(255 * unit - ideal[0]);
      total.errors.max = std::max(total.errors.max, error);
      total.errors.rms += error * error;
      ++total.pixels;
      total.samples += taken;
      total.excluded += SampleCount(result.footprint.pattern) - taken;
    });
  }
  total.errors.rms = std::sqrt(total.errors.rms / static_cast<double>(total.pixels));
  return total;
}

}  // namespace shading::accuracy
