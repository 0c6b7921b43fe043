// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/vectors.h"

namespace shading::stress {
namespace {

Check Product() {
  Check check = CheckOf(DotProduct::kContract, "2^-30", "cosine S1.29");
  check.genes = {"N, turn", "N, height", "L, turn", "L, height"};
  check.error = [](const Genes& g, int narrow) {
    const auto n = Rounded<PixelNormalComponent>(Direction(g[0], g[1]));
    const auto l = Rounded<NormalComponent>(Direction(g[2], g[3]));
    const Real ideal = std::ldexp(Dot(RealOf(n), RealOf(l)), 30);
    return static_cast<double>(
        std::abs(static_cast<Real>(Narrowed(DotProduct::Of(n, l).raw(), narrow)) - ideal));
  };
  return check;
}

// x near 1, equally likely in every octave of 1 - x; n of 1..256.
struct Power {
  Cosine x;
  Shininess n;
  Real ideal;
};
Power PowerOf(const Genes& g) {
  const Real gap =
      g[2] < 0.2 ? static_cast<Real>(g[0]) : std::pow(2.0L, -30 * static_cast<Real>(g[0]));
  const Power p = {Cosine::FromRaw(RoundTo(1 - gap, 30)),
                   Shininess::FromRaw(128 + static_cast<int64_t>(g[1] * (255 * 128))), 0};
  return {p.x, p.n,
          std::pow(std::ldexp(static_cast<Real>(p.x.raw()), -30),
                   std::ldexp(static_cast<Real>(p.n.raw()), -7))};
}
const std::vector<std::string> kPower = {"1 - x", "shininess 1..256", "scale of 1 - x"};

Check Blinn() {
  Check check = CheckOf(BlinnSpecular::kContract, "2^-16", "highlight U1.15");
  check.genes = kPower;
  check.error = [](const Genes& g, int narrow) {
    const Power p = PowerOf(g);
    const int64_t raw = Narrowed(BlinnSpecular(p.n).Of(p.x).raw(), narrow);
    return static_cast<double>(std::abs(static_cast<Real>(raw) - std::ldexp(p.ideal, 16)));
  };
  return check;
}

Check FinePower() {
  Check check = CheckOf(SpecularPower::kContract, "2^-30", "factor U1.29");
  check.genes = kPower;
  check.error = [](const Genes& g, int narrow) {
    const Power p = PowerOf(g);
    const int64_t raw = Narrowed(SpecularPower::Of(p.x, p.n).raw(), narrow);
    return static_cast<double>(std::abs(static_cast<Real>(raw) - std::ldexp(p.ideal, 30)));
  };
  return check;
}

Check Specular() {
  Check check =
      CheckOf(SpecularCosine::kContract, "2^-30 of R.V, 2^-17 of N.L", "outputs a bit less");
  check.genes = {"N.L", "N.V", "L.V"};
  check.error = [](const Genes& g, int narrow) {
    const auto cosine = [&](size_t i) { return RoundTo(2 * static_cast<Real>(g[i]) - 1, 30); };
    const int64_t l = cosine(0), v = cosine(1), lv = cosine(2);
    const Real exact =
        std::ldexp(static_cast<Real>(l) * static_cast<Real>(v), -29) - static_cast<Real>(lv);
    const Real ideal = std::clamp(exact, -std::ldexp(1.0L, 31), std::ldexp(1.0L, 31) - 1);
    const int64_t reflected =
        SpecularCosine::Reflected(static_cast<int32_t>(l), static_cast<int32_t>(v), lv);
    const int64_t diffuse = SpecularCosine::RawDiffuse(static_cast<int32_t>(l));
    const Real lit = std::ldexp(static_cast<Real>(std::max<int64_t>(l, 0)), -13);
    return static_cast<double>(
        std::max(std::abs(static_cast<Real>(Narrowed(reflected, narrow)) - ideal),
                 std::abs(static_cast<Real>(Narrowed(diffuse, narrow)) - lit)));
  };
  return check;
}

Check Combine() {
  Check check = CheckOf(RgbCombine::kContract, "codes", "code U7.0");
  check.genes = {"ambient", "diffuse reflectance", "specular reflectance", "N.L", "highlight"};
  check.error = [](const Genes& g, int narrow) {
    const auto raw = [&](size_t i) { return static_cast<int32_t>(std::lround(65536 * g[i])); };
    const auto lit = static_cast<int32_t>(std::lround(131072 * g[3]));
    const int64_t code = RgbCombine::RawCode({raw(0), raw(1), raw(2)}, lit, raw(4));
    const Real sum = std::ldexp(static_cast<Real>(raw(0)), -16) +
                     std::ldexp(static_cast<Real>(raw(1)) * lit, -33) +
                     std::ldexp(static_cast<Real>(raw(2)) * raw(4), -32);
    return static_cast<double>(
        std::abs(static_cast<Real>(Narrowed(code, narrow)) - 255 * std::min<Real>(sum, 1)));
  };
  return check;
}

// Two unit normals up to 120 degrees apart.
Check Mean() {
  Check check = CheckOf(MeanCosines::kContract, "2^-30", "cosine S1.29");
  check.genes = {"Na, turn", "Na, height", "Nb, turn", "Nb, height", "L, turn", "L, height"};
  check.error = [](const Genes& g, int narrow) {
    const std::array<Vector3, 2> n = {Rounded<NormalComponent>(Direction(g[0], g[1])),
                                      Rounded<NormalComponent>(Direction(g[2], g[3]))};
    const auto l = Rounded<NormalComponent>(Direction(g[4], g[5]));
    const Vector a = RealOf(n[0]), b = RealOf(n[1]);
    const Vector sum = {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
    const Real length = std::sqrt(Dot(sum, sum));
    if (length < 1) return 0.0;
    const std::array<LightCosines, 2> cosines = {LightCosines{CosineOf(n[0], l), {}},
                                                 LightCosines{CosineOf(n[1], l), {}}};
    const auto mean = MeanCosines::Of(n, cosines);
    const Real ideal = std::ldexp(Dot(sum, RealOf(l)) / length, 30);
    const int64_t raw = Narrowed(mean->n_dot_l.raw(), narrow);
    return static_cast<double>(std::abs(static_cast<Real>(raw) - ideal));
  };
  return check;
}

}  // namespace

std::vector<Check> LightChecks() {
  return {Product(), Blinn(), FinePower(), Specular(), Combine(), Mean()};
}

}  // namespace shading::stress
