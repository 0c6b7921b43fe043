// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "model/ideal/lighting.h"
#include "sim/stress/vectors.h"

namespace shading::stress {
namespace {

// A light, a viewer, a grey material and a normal about the peak of the highlight.
const std::vector<std::string> kLit = {"view, turn",
                                       "view, height",
                                       "light, turn",
                                       "light, height",
                                       "ambient 0..1/4",
                                       "diffuse",
                                       "specular, 1 - g^4",
                                       "shininess, 256 - 255 g^2",
                                       "normal from H, 2^(-14 g)",
                                       "its direction, turn",
                                       "its direction, height",
                                       "Blinn below 1/2, Phong"};

Vector RealOf(const Vector3& v) { return stress::RealOf<NormalComponent>(v); }
Vector Near(const Vector3& centre, const Genes& g) {
  const Vector way = Direction(g[9], g[10]), at = RealOf(centre);
  const auto size = static_cast<Real>(std::pow(2.0, -14 * g[8]));
  const Vector v = {at[0] + size * way[0], at[1] + size * way[1], at[2] + size * way[2]};
  return Dot(v, v) < 1e-6L ? at : Unit(v);  // H itself where the two cancel
}
Rgb Grey(double value) {
  const Reflectance r = Reflectance::Round(value);
  return {r, r, r};
}

struct Lit {
  FrameState frame;
  Material material;
  Vector normal;  // real
  bool valid = false;
};
Lit LitOf(const Genes& g) {
  Lit lit;
  const Vector view = Direction(g[0], g[1]), light = Direction(g[2], g[3]);
  const Vector half = {view[0] + light[0], view[1] + light[1], view[2] + light[2]};
  if (Dot(half, half) < 0.01L) return lit;
  lit.frame.view = Rounded<NormalComponent>(view);
  lit.frame.light = Rounded<NormalComponent>(light);
  lit.frame.half = Rounded<NormalComponent>(Unit(half));
  lit.frame.lighting = g[11] < 0.5 ? Lighting::kBlinn : Lighting::kPhong;
  lit.material.ambient = Grey(g[4] / 4);
  lit.material.diffuse = Grey(g[5]);
  lit.material.specular = Grey(1 - std::pow(g[6], 4));
  lit.material.shininess = Shininess::Round(256 - 255 * g[7] * g[7]);
  lit.normal = Near(lit.frame.half, g);
  lit.valid = true;
  return lit;
}

// ka + kd (N.L) + ks (N.H)^n or (R.V)^n, clamped: paper 000 (1), (12), in codes.
Real LightOf(const Lit& lit, const Vector& n) {
  const Real l = Dot(n, RealOf(lit.frame.light)), h = Dot(n, RealOf(lit.frame.half));
  const Real v = Dot(n, RealOf(lit.frame.view));
  const Real lv = Dot(RealOf(lit.frame.light), RealOf(lit.frame.view));
  const Real x = lit.frame.lighting == Lighting::kBlinn ? h : 2 * l * v - lv;
  const Real highlight = std::pow(std::clamp<Real>(x, 0, 1), lit.material.shininess.ToReal());
  const Real sum = lit.material.ambient[0].ToReal() +
                   lit.material.diffuse[0].ToReal() * std::clamp<Real>(l, 0, 1) +
                   lit.material.specular[0].ToReal() * highlight;
  return 255 * std::min<Real>(sum, 1);
}

template <typename Fixed>
Fixed Less(Fixed value, int narrow) {
  return Fixed::Wrap(Narrowed(value.raw(), narrow));
}

Check Vertex() {
  Check check = CheckOf(VertexLight::kContract, "2^-16 codes", "cosines S1.29");
  check.genes = kLit;
  check.error = [](const Genes& g, int narrow) {
    const Lit lit = LitOf(g);
    if (!lit.valid) return 0.0;
    FrameState frame = lit.frame;
    const VertexLight unit(frame);
    const auto normal = Rounded<NormalComponent>(lit.normal);
    LightCosines cosines = unit.Cosines(normal);
    cosines = {Less(cosines.n_dot_l, narrow), Less(cosines.n_dot_h_or_v, narrow)};
    const int64_t raw = unit.Shade(cosines, lit.material)[0].raw();
    return static_cast<double>(
        std::abs(static_cast<Real>(raw) - std::ldexp(LightOf(lit, RealOf(normal)), 16)));
  };
  check.cost = 2;
  return check;
}

// Of real cosines, rounded to the unit's.
Check PixelCode() {
  Check check = CheckOf(PixelLight::kContract, "codes", "code U7.0");
  check.genes = kLit;
  check.error = [](const Genes& g, int narrow) {
    const Lit lit = LitOf(g);
    if (!lit.valid) return 0.0;
    const LightState state = shading::LightOf(lit.frame);
    PixelLight unit(state);
    unit.SetMaterial(lit.material);
    const auto cosine = [&](const Vector3& v) {
      return Cosine::Wrap(RoundTo(Dot(lit.normal, RealOf(v)), Cosine::kFraction));
    };
    const PixelCodes codes = unit.Shade({cosine(state.light), cosine(state.half_or_view)});
    return static_cast<double>(
        std::abs(static_cast<Real>(Narrowed(codes.r, narrow)) - LightOf(lit, lit.normal)));
  };
  check.cost = 3;
  return check;
}

// The exact quotient of up to eight samples, the first of which may count twice.
Check Mean() {
  Check check = CheckOf(FootprintMean::kContract, "of each output", "outputs U1.16, U1.15");
  check.genes = {"samples 1..7", "the first counts twice", "a", "b", "c", "d", "e", "f", "g"};
  check.error = [](const Genes& g, int narrow) {
    const auto samples = std::min(7, 1 + static_cast<int>(7 * g[0]));
    FootprintMean unit;
    int64_t diffuse = 0, highlight = 0, weights = 0;
    for (int s = 0; s < samples; ++s) {
      const int weight = s == 0 && g[1] >= 0.5 ? 2 : 1;
      const auto raw = static_cast<int64_t>(std::lround(g[static_cast<size_t>(2 + s)] * 65536));
      unit.Add({Diffuse::FromRaw(2 * raw), Highlight::FromRaw(raw)}, weight);
      diffuse += weight * 2 * raw;
      highlight += weight * raw;
      weights += weight;
    }
    const auto off = [&](int64_t raw, int64_t sum) {
      return std::abs(static_cast<double>(Narrowed(raw, narrow)) -
                      static_cast<double>(sum) / static_cast<double>(weights));
    };
    const FootprintMean::Light mean = unit.Mean();
    return std::max(off(mean.diffuse.raw(), diffuse), off(mean.highlight.raw(), highlight));
  };
  return check;
}

}  // namespace

std::vector<Check> VertexChecks() { return {Vertex(), PixelCode(), Mean()}; }

}  // namespace shading::stress
