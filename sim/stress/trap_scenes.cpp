// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>

#include "model/contracts.h"
#include "sim/stress/model_value.h"
#include "sim/stress/narrow_recurrence.h"
#include "sim/stress/triangle_genes.h"
#include "sim/stress/trouble.h"

namespace shading::stress {
namespace {

constexpr int kFraction = IntensityAcc::kFraction;

// N.H of 1 + 2^-k in the power: the clamp comes first.
Condition Overshoot(bool, uint32_t) {
  Condition c{"traps", "N.H above 1, up to 2 - 2^-30, n = 1..256",
              "highlight above 1, codes; naive: 255 x^n, x = 1 + 2^-10"};
  for (int n = 1; n <= 256; ++n) {
    for (int k = 0; k <= 30; ++k, ++c.cases) {
      const Cosine x = Cosine::FromRaw((int64_t{1} << 30) + (int64_t{1} << (30 - k)) - (k == 0));
      const Shininess shininess = Shininess::FromRaw(int64_t{n} << Shininess::kFraction);
      const double power = SpecularPower::Of(x, shininess).ToReal();
      const double fine = BlinnSpecular(shininess).Of(x).ToReal();
      c.worst = std::max({c.worst, 255 * (power - 1), 255 * (fine - 1)});
    }
  }
  c.naive = 255 * std::pow(1 + 0x1p-10, 256) - 255;
  return c;
}

// N.L from behind to full light. Naive: the clamped value goes back into the register.
Condition DarkToLit(bool, uint32_t) {
  Condition c{"traps", "N.L from -0.8 to 0.8 along 256 pixels",
              "codes off at the last pixel; naive: the clamped value is fed back"};
  const Real turn = 2 * std::asin(0.8L), phi = turn / 255;
  const Arc arc{phi, -kPi / 2 - turn / 2};
  const QuantitySeed seed = {Quantity::Wrap(RoundTo(arc.At(0), 38)),
                             Quantity::Wrap(RoundTo(arc.FirstDifference(), 38))};
  SlerpRecurrence unit(seed, KappaOf(phi));
  Real value = 0, difference = std::ldexp(static_cast<Real>(seed.difference.raw()), -38);
  value = std::max<Real>(0, arc.At(0));
  const Real kappa = 4 * std::sin(phi / 2) * std::sin(phi / 2);
  for (int t = 0; t < 255; ++t) {
    unit.Step();
    value = std::max<Real>(0, value + difference);
    difference -= kappa * value;
  }
  const Real ideal = std::max<Real>(0, arc.At(255));
  const Real shown = std::max<Real>(0, std::ldexp(static_cast<Real>(unit.value().raw()), -38));
  c.cases = 1;
  c.worst = static_cast<double>(255 * std::abs(shown - ideal));
  c.naive = static_cast<double>(255 * std::abs(value - ideal));
  c.limit = 0.001;
  return c;
}

// Paper 003 (5). Naive: the codes as they are shown go back.
Condition CodesFedBack(bool, uint32_t) {
  Condition c{"traps", "paper 003 (5), 10 to 250 codes and back along 2048 pixels",
              "codes off, worst pixel; naive: rounded codes are fed back"};
  constexpr int kLast = 2047;
  const Real a = -960.0L / kLast / kLast, d = 960.0L / kLast;
  const auto at = [&](int t) { return 10 + d * t + a * t * t; };
  const auto kept = [](Real v) { return IntensityAcc::Wrap(RoundTo(v, kFraction)); };
  const ChannelSeed seed = {kept(at(0)), kept(at(1)), {}, kept(2 * a)};
  BasicQuadSurface<SeenWord> unit(seed);
  Real zero = std::round(at(0)), one = std::round(at(1)), naive = 0;
  for (int t = 0; t <= kLast; ++t, unit.Step(), ++c.cases) {
    (void)unit.whole();
    const Real shown = std::ldexp(static_cast<Real>(SeenWord::Seen().raw()), -kFraction);
    c.worst = std::max(c.worst, static_cast<double>(std::abs(shown - at(t))));
    Raise(&naive, std::abs(zero - at(t)));
    const Real next = std::round(2 * one - zero + 2 * a);
    zero = one;
    one = next;
  }
  c.naive = static_cast<double>(naive);
  c.limit = 0.0313;
  return c;
}

// Slivers whose coefficients leave S9.26, by the exact A, B, C; whatever they wrap to, covered
// pixels must be right.
Condition RegistersLeft(bool quick, uint32_t seed) {
  Condition c{"traps", "slivers whose A, B or C leaves S9.26", "triangles with a wrong pixel"};
  const std::vector<Check> checks = TriangleChecks();
  const Check& fit = *std::find_if(checks.begin(), checks.end(),
                                   [](const Check& k) { return k.unit == "surface_fit"; });
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(0, 1);
  int drawn = 0;
  for (int i = 0; i < (quick ? 4000 : 100000); ++i) {
    Genes g(fit.genes.size());
    for (double& gene : g) gene = unit(random);
    g[0] = i % 2 ? 0.5 : 0.9;
    const TrianglePacket packet = CornersOf(g, kMaxScreen, kMaxScreen);
    const ExactWeights exact(packet);
    if (exact.area() == 0) continue;
    ++drawn;
    Real steepest = 0;
    for (size_t v = 0; v < 3; ++v)
      Raise(&steepest, std::abs(static_cast<Real>(exact.Dx(v)) / static_cast<Real>(exact.area())));
    if (steepest * steepest * 128 < 512) continue;  // |A| of a bend of 32 codes
    ++c.cases;
    c.worst += !(fit.error(g, 0) <= fit.bound);
  }
  c.measure += ", of " + std::to_string(drawn) + " slivers";
  return c;
}

}  // namespace

std::vector<Scene> TrapScenes() { return {Overshoot, DarkToLit, CodesFedBack, RegistersLeft}; }

}  // namespace shading::stress
