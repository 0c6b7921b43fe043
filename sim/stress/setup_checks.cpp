// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/adaptive_error.h"
#include "sim/stress/span_arcs.h"

namespace shading::stress {
namespace {

const std::vector<std::string> kArc = {
    "direction, turn", "direction, height", "turn of the arc's plane",
    "turn: below 1/2 logarithm of 0.0001..90 degrees, 85..90", "pixels, logarithm of 2..4096"};

double TurnOfGene(double gene) {
  return gene < 0.5 ? Geometric(1e-4, 90, 2 * gene) : Between(85, 90, 2 * gene - 1);
}
SpanCommand SpanOfGenes(const Genes& g) {
  const Real turn = kPi / 180 * static_cast<Real>(TurnOfGene(g[3]));
  return SpanOf(GreatArc::Of(g), turn, PixelsOf(g[4], 4096));
}

// Seeds and kappa with `narrow` bits less; the exact recurrence from them against slerp.
Check Setup() {
  Check check = CheckOf(NormalSetup::kContract, "2^-30", "seeds S1.37, kappa U1.27");
  check.genes = kArc;
  check.genes.push_back("lanes: below 1/2 one, four");
  check.error = [](const Genes& g, int narrow) {
    const SpanCommand span = SpanOfGenes(g);
    const Real turn = TurnBetween(span);
    if (turn > kPi / 2) return 0.0;
    const int lanes = g[5] < 0.5 ? 1 : 4, last = span.length - 1;
    NormalSeed seed;
    NormalSetup::Seed({true, false, false}, {}, span, lanes, &seed);
    const Real kappa = KappaReal(seed.kappa, narrow);
    Real worst = 0;
    for (int lane = 0; lane < std::min(lanes, last + 1); ++lane) {
      const int steps = (last - lane) / lanes;
      for (const int k : {1, steps / 3, steps / 2, 2 * steps / 3, steps}) {
        if (k > steps) continue;
        const Vector ideal = SlerpAt(span, turn, lane + k * lanes);
        for (size_t i = 0; i < 3; ++i) {
          const QuantitySeed& s = seed.quantity[i][static_cast<size_t>(lane)];
          const Real at = ExactRecurrence(Narrowed(s.first.raw(), narrow),
                                          Narrowed(s.difference.raw(), narrow), kappa, k);
          Raise(&worst, std::abs(std::ldexp(at, -38) - ideal[i]));
        }
      }
    }
    return static_cast<double>(std::ldexp(worst, 30));
  };
  check.starts = {{0.1, 0.3, 0.2, 0.78, 0.99, 1}, {0.1, 0.3, 0.2, 0.4, 0.99, 1}};
  check.cost = 25;
  return check;
}

// The arc against the great circle that its own inputs, a first difference and kappa, define.
Check DirectSetup() {
  Check check = CheckOf(SlerpDirectSetup::kContract, "2^-30",
                        "side S1.29, step U1.39, straight spans by 2^-24");
  check.genes = kArc;
  check.error = [](const Genes& g, int narrow) {
    const SpanCommand span = SpanOfGenes(g);
    NormalSeed seed;
    NormalSetup::Seed({true, false, false}, {}, span, 1, &seed);
    const std::array<QuantitySeed, 3> quantity = {seed.quantity[0][0], seed.quantity[1][0],
                                                  seed.quantity[2][0]};
    const Real kappa = KappaReal(seed.kappa, 0);
    if (kappa > 0.625L) return 0.0;
    const SpanArc arc = SlerpDirectSetup::Of(quantity, seed.kappa);
    // A bit less makes the angle that stands for a straight span twice as large.
    const int twice = narrow > 0 && kappa == 0 && span.length > 2;
    const Real step = std::ldexp(static_cast<Real>(Narrowed(arc.step.raw(), narrow)), twice - 40);
    const int last = span.length - 1;
    Real worst = 0;
    for (const int t : {1, last / 3, last / 2, 2 * last / 3, last}) {
      const Real c = std::cos(t * step), s = std::sin(t * step);
      for (size_t i = 0; i < 3; ++i) {
        const Real ideal =
            ExactRecurrence(quantity[i].first.raw(), quantity[i].difference.raw(), kappa, t);
        const Real at = std::ldexp(
            c * static_cast<Real>(arc.start[i].raw()) +
                std::ldexp(s, -twice) * static_cast<Real>(Narrowed(arc.side[i].raw(), narrow)),
            8);
        Raise(&worst, std::abs(at - ideal));
      }
    }
    return static_cast<double>(std::ldexp(worst, -8));
  };
  check.starts = {{0.1, 0.3, 0.2, 0.1, 0.99}, {0.6, 0.5, 0.2, 0.12, 1}};
  check.cost = 5;
  return check;
}

Check Adaptive() {
  Check check = CheckOf(AdaptiveNormalizer::kContract, "codes", "normals S1.23");
  check.genes = kArc;
  check.genes[3] = "turn: below 1/2 logarithm of 0.01..120 degrees, a power of 2 of parts";
  check.genes[4] = "pixels, logarithm of 2..4096";
  check.genes.push_back("shininess, logarithm of 1..256; below 1/8 diffuse only");
  check.genes.push_back("tolerance: below 1/2 none, logarithm of 1/16..8 codes");
  check.error = AdaptiveExcess;
  // Just under 90 degrees, 4096 pixels, n = 256, tolerance 0: every pixel a node.
  check.starts = {{0.1178, 0.9968, 0.4062, 0.499, 1, 1, 0.2544},
                  {0.7426, 0.0000016, 0.5534, 0.4995, 0.9999, 1, 0.3384}};
  check.cost = 400;
  return check;
}

}  // namespace

std::vector<Check> SetupChecks() { return {Setup(), DirectSetup(), Adaptive()}; }

}  // namespace shading::stress
