// SPDX-License-Identifier: Apache-2.0
#include "tests/accuracy/footprint_plane.h"

#include <algorithm>
#include <cmath>

#include "model/footprint/footprint_light.h"
#include "model/footprint/footprint_setup.h"

namespace shading::accuracy {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kRings = 64, kSpokes = 64;

// At the angle |(u, v)| from the z axis.
Vector3 Direction(double u, double v) {
  const double angle = std::hypot(u, v), scale = angle > 0 ? std::sin(angle) / angle : 0;
  return {NormalComponent::Round(u * scale), NormalComponent::Round(v * scale),
          NormalComponent::Round(std::cos(angle))};
}

// Mean of (N.H)^n over the ellipse with semi-axes a, b; N = (x, y, 1) normalised.
double IdealMean(double a, double b, const Vector3& half, int n) {
  const double hx = half[0].ToReal(), hy = half[1].ToReal(), hz = half[2].ToReal();
  double sum = 0;
  for (int ring = 0; ring < kRings; ++ring) {
    const double radius = std::sqrt((ring + 0.5) / kRings);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double angle = 2 * kPi * (spoke + 0.5 * (ring % 2)) / kSpokes;
      const double x = a * radius * std::cos(angle), y = b * radius * std::sin(angle);
      const double cosine = (x * hx + y * hy + hz) / std::sqrt(x * x + y * y + 1);
      if (cosine > 0) sum += std::pow(cosine, n);
    }
  }
  return sum / (kRings * kSpokes);
}

FootprintSetup::Axis AxisAlong(double x, double y) {
  FootprintSetup::Axis axis = {};
  axis.normal = {Quantity::Round(x).raw(), Quantity::Round(y).raw(), 0};
  return axis;
}

struct Plane {
  double major, minor;  // tangents of the turns
  std::array<Footprint, kFootprintPatterns> footprint;

  Plane(double ratio, double turn)
      : major(std::tan(turn * kPi / 180)), minor(std::tan(turn / ratio * kPi / 180)) {
    for (size_t p = 0; p < footprint.size(); ++p) {
      footprint[p].pattern = static_cast<FootprintPattern>(p);
      footprint[p].offset =
          FootprintSetup::Offsets(footprint[p].pattern, AxisAlong(major, 0), AxisAlong(0, minor));
    }
  }
};

double UnitMean(const Footprint& footprint, const FootprintLight& light) {
  const std::array<Quantity, 3> centre = {Quantity(), Quantity(), Quantity::Round(1)};
  AnisoFootprint samples(footprint, {}, 0, 1);
  return light.Mean(footprint.pattern, centre, &samples).highlight.ToReal();
}

}  // namespace

PlaneErrors ErrorsOnPlane(double ratio, double turn, int n, int grid) {
  const Plane plane(ratio, turn);
  const double widest = std::min(n == 1 ? 1.65 : 1.4, 4 / std::sqrt(n) + turn * kPi / 180);
  PlaneErrors errors;
  for (int i = 0; i < grid; ++i) {
    for (int j = 0; j < grid; ++j) {
      const double u = widest * i / (grid - 1), v = widest * j / (grid - 1);
      LightState light;
      light.half_or_view = Direction(u, v);
      FootprintLight unit(light);
      Material material;
      material.specular[0] = Reflectance::Round(1);
      material.shininess = Shininess::Round(n);
      unit.SetMaterial(material);
      const double ideal = IdealMean(plane.major, plane.minor, light.half_or_view, n);
      for (size_t p = 0; p < errors.pattern.size(); ++p) {
        const double error = 255 * std::abs(UnitMean(plane.footprint[p], unit) - ideal);
        errors.pattern[p].max = std::max(errors.pattern[p].max, error);
        errors.pattern[p].rms += error * error / (grid * grid);
      }
    }
  }
  for (FootprintErrors& e : errors.pattern) e.rms = std::sqrt(e.rms);
  const auto square = [n](double tangent) {
    return std::llround(std::ldexp(n * tangent * tangent, 20));
  };
  errors.chosen = FootprintSetup::PatternFor(square(plane.major), square(plane.minor),
                                             FootprintSetup::Options().tolerance);
  return errors;
}

}  // namespace shading::accuracy
