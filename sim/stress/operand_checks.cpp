// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/check.h"

namespace shading::stress {
namespace {

using Vector = std::array<Real, 3>;

Check Of(const UnitContract& unit, const std::string& ulp, const std::string& narrowed) {
  Check check;
  check.unit = unit.name;
  check.bound = unit.max_error_ulp;
  check.valid = unit.valid_for;
  check.ulp = ulp;
  check.narrowed = narrowed;
  return check;
}

Vector Direction(double turn, double height) {
  const Real z = 2 * static_cast<Real>(height) - 1, r = std::sqrt(1 - z * z);
  return {r * std::cos(2 * kPi * turn), r * std::sin(2 * kPi * turn), z};
}
Real Dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
template <typename Fixed>
std::array<Fixed, 3> Rounded(const Vector& v) {
  std::array<Fixed, 3> fixed;
  for (size_t i = 0; i < 3; ++i) fixed[i] = Fixed::Wrap(RoundTo(v[i], Fixed::kFraction));
  return fixed;
}
template <typename Fixed>
Vector RealOf(const std::array<Fixed, 3>& fixed) {
  Vector v;
  for (size_t i = 0; i < 3; ++i)
    v[i] = std::ldexp(static_cast<Real>(fixed[i].raw()), -Fixed::kFraction);
  return v;
}
template <typename Fixed>
double Farthest(const std::array<Fixed, 3>& actual, const Vector& ideal, int narrow) {
  Real worst = 0;
  for (size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, std::abs(static_cast<Real>(Narrowed(actual[i].raw(), narrow)) -
                                     std::ldexp(ideal[i], Fixed::kFraction)));
  }
  return static_cast<double>(worst);
}

Check Root() {
  Check check = Of(ReciprocalSqrt::kContract, "2^-24", "mantissa U1.23");
  check.genes = {"q, 1..4", "octave"};
  check.error = [](const Genes& g, int narrow) {
    const auto x = static_cast<int64_t>(std::ldexp(1 + 3 * static_cast<Real>(g[0]), 44)) - 1;
    const int64_t q = std::max<int64_t>(x >> (2 * static_cast<int>(22 * g[1])), 1);
    const ReciprocalRoot root = ReciprocalSqrt::Of(SquaredLength::FromRaw(q));
    const Real ideal =
        std::ldexp(1 / std::sqrt(std::ldexp(static_cast<Real>(q), -44)), 24 - root.exponent);
    return static_cast<double>(
        std::abs(static_cast<Real>(Narrowed(root.mantissa.raw(), narrow)) - ideal));
  };
  return check;
}

const std::vector<std::string> kDirection = {"direction, turn", "direction, height"};

// Components of a normal of any direction and of `low` to 1 + 2^-9.
std::array<Quantity, 3> NormalOf(const Genes& g, double low) {
  Vector v = Direction(g[0], g[1]);
  const double length = Geometric(low, 1 + std::ldexp(1, -9) - 1e-9, g[2]);
  for (Real& c : v) c *= length;
  return Rounded<Quantity>(v);
}

Check Direct() {
  Check check = Of(PhongDirect::kContract, "2^-24", "components S1.23");
  check.genes = kDirection;
  check.genes.push_back("length, logarithm of 1/8..1 + 2^-9");
  check.error = [](const Genes& g, int narrow) {
    const auto m = NormalOf(g, 0.125);
    Vector v = RealOf(m);
    const Real length = std::sqrt(Dot(v, v));
    for (Real& c : v) c /= length;
    return Farthest(PhongDirect::Of(m), v, narrow);
  };
  return check;
}

Check Taylor() {
  Check check = Of(TaylorNormalizer::kContract, "2^-24", "components S1.23");
  check.genes = kDirection;
  check.genes.push_back("length, logarithm of 1/1000..1 + 2^-9");
  check.error = [](const Genes& g, int narrow) {
    const auto m = NormalOf(g, 1e-3);
    Vector v = RealOf(m);
    const Real d = Dot(v, v) - 1;
    for (Real& c : v) c *= 1 - d / 2 + d * d * 3 / 8;
    return Farthest(TaylorNormalizer::Of(m), v, narrow);
  };
  return check;
}

Check Duff() {
  Check check = Of(DuffNormalizer::kContract, "2^-30", "mantissa of the root U1.23");
  check.genes = {"q, 1/2..2", "dot product, part of the root of q", "octave"};
  check.error = [](const Genes& g, int narrow) {
    const int64_t q = static_cast<int64_t>(std::ldexp(Between(0.5, 2, g[0]), 44) - 1) >>
                      (2 * static_cast<int>(16 * g[2]));
    const Real root = std::sqrt(std::ldexp(static_cast<Real>(q), -44));
    const Real most = std::min<Real>(root, 2 - std::ldexp(1.0L, -38));
    const auto dot = static_cast<int64_t>(std::ldexp(most * (2 * static_cast<Real>(g[1]) - 1), 38));
    const Real ideal = std::ldexp(static_cast<Real>(dot), 30 - 38) / root;
    int64_t raw =
        DuffNormalizer::Of(Quantity::Wrap(dot), Quantity(), LengthSquare::Wrap(q)).n_dot_l.raw();
    if (narrow > 0) {  // the unit's product with a narrowed mantissa
      const ReciprocalRoot short_root = ReciprocalSqrt::Of(SquaredLength::FromRaw(q));
      const int64_t scaled = (dot * (int64_t{1} << short_root.exponent)) >> 8;
      raw = RoundSaturateCosine(scaled * Narrowed(short_root.mantissa.raw(), narrow), 24).raw();
    }
    return static_cast<double>(std::abs(static_cast<Real>(raw) - ideal));
  };
  return check;
}

Check Cordic() {
  Check check = Of(SlerpDirect::kContract, "2^-24", "components S1.23");
  check.genes = {"direction, turn", "direction, height", "turn of the arc's plane",
                 "angle 0..1.74"};
  check.error = [](const Genes& g, int narrow) {
    const Vector a = Direction(g[0], g[1]), other = Direction(g[2], 0.5);
    Vector side;
    for (size_t i = 0; i < 3; ++i) side[i] = other[i] - Dot(other, a) * a[i];
    const Real length = std::sqrt(Dot(side, side));
    if (length < 1e-3L) return 0.0;
    for (Real& c : side) c /= length;
    SpanArc arc{Angle::FromRaw(RoundTo(1.74L * g[3], 40)), Rounded<SpanNormalComponent>(a),
                Rounded<SpanNormalComponent>(side)};
    SlerpDirect unit(arc);
    unit.Step();
    const Real angle = std::ldexp(static_cast<Real>(arc.step.raw()), -40);
    const Vector start = RealOf(arc.start), quarter = RealOf(arc.side);
    Vector ideal;
    for (size_t i = 0; i < 3; ++i)
      ideal[i] = std::cos(angle) * start[i] + std::sin(angle) * quarter[i];
    return Farthest(unit.normal(), ideal, narrow);
  };
  return check;
}

Check Product() {
  Check check = Of(DotProduct::kContract, "2^-30", "cosine S1.29");
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
  Check check = Of(BlinnSpecular::kContract, "2^-16", "highlight U1.15");
  check.genes = kPower;
  check.error = [](const Genes& g, int narrow) {
    const Power p = PowerOf(g);
    const int64_t raw = Narrowed(BlinnSpecular(p.n).Of(p.x).raw(), narrow);
    return static_cast<double>(std::abs(static_cast<Real>(raw) - std::ldexp(p.ideal, 16)));
  };
  return check;
}

Check FinePower() {
  Check check = Of(SpecularPower::kContract, "2^-30", "factor U1.29");
  check.genes = kPower;
  check.error = [](const Genes& g, int narrow) {
    const Power p = PowerOf(g);
    const int64_t raw = Narrowed(SpecularPower::Of(p.x, p.n).raw(), narrow);
    return static_cast<double>(std::abs(static_cast<Real>(raw) - std::ldexp(p.ideal, 30)));
  };
  return check;
}

Check Specular() {
  Check check = Of(SpecularCosine::kContract, "2^-30 of R.V, 2^-17 of N.L", "outputs a bit less");
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
  Check check = Of(RgbCombine::kContract, "codes", "code U7.0");
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
  Check check = Of(MeanCosines::kContract, "2^-30", "cosine S1.29");
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

std::vector<Check> OperandChecks() {
  return {Root(),  Direct(),    Taylor(),   Duff(),    Cordic(), Product(),
          Blinn(), FinePower(), Specular(), Combine(), Mean()};
}

std::vector<Check> AllChecks() {
  std::vector<Check> all = RecurrenceChecks();
  for (Check& check : OperandChecks()) all.push_back(std::move(check));
  return all;
}

std::vector<Exempt> Exemptions() {
  const char* kExact = "states no error: integers, compared bit by bit by the unit test";
  const char* kUnitTest = "its bound is searched by the unit test only, not yet here";
  std::vector<Exempt> exempt;
  const std::vector<Check> checks = AllChecks();
  for (const UnitContract& unit : kContracts) {
    const auto same = [&](const Check& c) { return c.unit == unit.name; };
    if (std::any_of(checks.begin(), checks.end(), same)) continue;
    exempt.push_back({unit.name, unit.max_error_ulp == 0 ? kExact : kUnitTest});
  }
  return exempt;
}

}  // namespace shading::stress
