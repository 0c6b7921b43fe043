// SPDX-License-Identifier: Apache-2.0
#include "model/contracts.h"
#include "sim/stress/vectors.h"

namespace shading::stress {
namespace {

Check Root() {
  Check check = CheckOf(ReciprocalSqrt::kContract, "2^-24", "mantissa U1.23");
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
  Check check = CheckOf(PhongDirect::kContract, "2^-24", "components S1.23");
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
  Check check = CheckOf(TaylorNormalizer::kContract, "2^-24", "components S1.23");
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
  Check check = CheckOf(DuffNormalizer::kContract, "2^-30", "mantissa of the root U1.23");
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
  Check check = CheckOf(SlerpDirect::kContract, "2^-24", "components S1.23");
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

}  // namespace

std::vector<Check> NormalChecks() { return {Root(), Direct(), Taylor(), Duff(), Cordic()}; }

}  // namespace shading::stress
