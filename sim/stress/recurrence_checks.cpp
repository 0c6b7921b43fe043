// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/narrow_recurrence.h"
#include "sim/stress/quad_drift.h"

namespace shading::stress {
namespace {

constexpr int kLast = 2047;  // the last of the pixels for which bounds are stated

Check Of(const UnitContract& unit) {
  Check check;
  check.unit = unit.name;
  check.bound = unit.max_error_ulp;
  check.valid = unit.valid_for;
  return check;
}

// Turns of 0.001 .. 90 degrees in 2048 pixels.
Arc ArcOf(const Genes& g) {
  const Real turn = kPi / 180 * static_cast<Real>(Geometric(0.001, 90, g[0]));
  return {turn / kLast, 2 * kPi * static_cast<Real>(g[1]) - turn / 2};
}

Check Slerp() {
  Check check = Of(SlerpRecurrence::kContract);
  check.ulp = "2^-28";
  check.narrowed = "state S1.37, multiplier operand S1.27";
  check.genes = {"turn, logarithm of 0.001..90 degrees", "phase of the middle, 0..2 pi"};
  check.error = [](const Genes& g, int narrow) {
    const Arc arc = ArcOf(g);
    const int f = 38 - narrow;
    Real value = 0;
    if (narrow == 0) {
      SlerpRecurrence unit({Quantity::Wrap(RoundTo(arc.At(0), 38)),
                            Quantity::Wrap(RoundTo(arc.FirstDifference(), 38))},
                           KappaOf(arc.phi));
      for (int t = 0; t < kLast; ++t) unit.Step();
      value = static_cast<Real>(unit.value().raw());
    } else {
      NarrowRecurrence unit(arc, f);
      for (int t = 0; t < kLast; ++t) unit.Step();
      value = static_cast<Real>(unit.value());
    }
    return static_cast<double>(std::ldexp(std::abs(std::ldexp(value, -f) - arc.At(kLast)), 28));
  };
  // kappa s just under half an ulp of the state: the curve is drawn as a straight line.
  for (const int f : {38, 37}) {
    const double turn = kLast * std::sqrt(std::ldexp(0.99, -f - 1)) * 180 / M_PI;
    check.starts.push_back({std::log(turn / 0.001) / std::log(90 / 0.001), 0});
  }
  check.cost = 5;
  check.blind = 0.8;
  return check;
}

Check Paper() {
  Check check = Of(SlerpPaper::kContract);
  check.ulp = "2^-38";
  check.narrowed = "state and factors of 37 fraction bits";
  check.genes = {"turn, logarithm of 0.001..90 degrees", "phase of the middle, 0..2 pi"};
  check.error = [](const Genes& g, int narrow) {
    const Arc arc = ArcOf(g);
    const std::array<QuantitySeed, kMaxLanes> seed = {
        QuantitySeed{Quantity::Wrap(RoundTo(arc.At(0), 38)),
                     Quantity::Wrap(RoundTo(arc.FirstDifference(), 38))}};
    SlerpPaper unit(seed, {KappaOf(arc.phi), KappaOf(2 * arc.phi)}, 1, 38 - narrow);
    for (int t = 0; t < kLast; ++t) unit.Step();
    return static_cast<double>(
        std::abs(static_cast<Real>(unit.value().raw()) - std::ldexp(arc.At(kLast), 38)));
  };
  check.cost = 15;
  return check;
}

// A line whose start and slope are off by what rounding may be off, in 2^-f; the exact recurrences
// show what the seeds are off.
double Fraction(double gene) { return gene - 0.5; }

Check Linear() {
  Check check = Of(LinearRecurrence::kContract);
  check.ulp = "2^-38";
  check.narrowed = "seeds S1.37";
  check.genes = {"start -1..1", "its part below an ulp", "end -1..1", "part of the slope"};
  check.error = [](const Genes& g, int narrow) {
    const Real unit = std::ldexp(1.0L, narrow - 38);
    const auto grid = [&](Real v) { return std::round(v / unit) * unit; };
    const Real first = grid(2 * g[0] - 1) + Fraction(g[1]) * unit;
    const Real slope = grid((2 * g[2] - 2 * g[0]) / kLast) + Fraction(g[3]) * unit;
    LinearRecurrence line({Quantity::Wrap(RoundNarrow(first, 38, narrow)),
                           Quantity::Wrap(RoundNarrow(slope, 38, narrow))});
    for (int t = 0; t < kLast; ++t) line.Step();
    return static_cast<double>(
        std::abs(static_cast<Real>(line.value().raw()) - std::ldexp(first + slope * kLast, 38)));
  };
  check.starts = {{0.3, 0, 0.6, 0}, {0.3, 1, 0.6, 1}};
  check.cost = 2;
  return check;
}

// |M|^2 between unit ends: 1 - 2 (1 - cosine) w (1 - w).
Check Length() {
  Check check = Of(LengthRecurrence::kContract);
  check.ulp = "2^-44";
  check.narrowed = "seeds S1.43";
  check.genes = {"cosine of the ends, -1..1"};
  check.error = [](const Genes& g, int narrow) {
    const Real gap = 2 - 2 * static_cast<Real>(g[0]);
    const Real bend = 4 * gap / (static_cast<Real>(kLast) * kLast);
    const Real slope = bend / 2 - 2 * gap / kLast;
    const auto seed = [&](Real v) { return LengthSquare::Wrap(RoundNarrow(v, 44, narrow)); };
    LengthRecurrence curve({seed(1), seed(slope), seed(bend)});
    for (int t = 0; t < kLast; ++t) curve.Step();
    return static_cast<double>(
        std::abs(static_cast<Real>(curve.value().raw()) - std::ldexp(1.0L, 44)));
  };
  check.cost = 2;
  return check;
}

Check Walker() {
  Check check = Of(PixelWalker::kContract);
  check.ulp = "2^-24";
  check.narrowed = "seeds S1.37";
  check.genes = {"part of the start below an ulp", "part of the slope", "slope, 0..1 a span"};
  check.error = [](const Genes& g, int narrow) {
    constexpr int kLastPixel = kMaxScreen - 1;
    const Real unit = std::ldexp(1.0L, narrow - 38);
    const Real first = 0.25L + Fraction(g[0]) * unit;
    const Real slope =
        (std::round(g[2] / 2 / kLastPixel / unit) + static_cast<Real>(Fraction(g[1]))) * unit;
    const int64_t at = RoundNarrow(first, 38, narrow) + kLastPixel * RoundNarrow(slope, 38, narrow);
    return static_cast<double>(std::ldexp(
        std::abs(std::ldexp(static_cast<Real>(at), -38) - first - slope * kLastPixel), 24));
  };
  check.starts = {{0, 0, 0.4}, {1, 1, 0.4}};
  return check;
}

Check Gouraud() {
  Check check = Of(GouraudInterpolator::kContract);
  check.ulp = "codes";
  check.narrowed = "seeds S9.25";
  check.genes = {"part of the start below an ulp", "part of the slope"};
  check.error = [](const Genes& g, int narrow) {
    const Real unit = std::ldexp(1.0L, narrow - 26);
    const Real first = 17 + Fraction(g[0]) * unit, slope = 0.03125L + Fraction(g[1]) * unit;
    constexpr int kLastPixel = kMaxScreen - 1;
    const int64_t at = RoundNarrow(first, 26, narrow) + kLastPixel * RoundNarrow(slope, 26, narrow);
    return static_cast<double>(
        std::abs(std::ldexp(static_cast<Real>(at), -26) - first - slope * kLastPixel));
  };
  check.starts = {{0, 0}, {1, 1}};
  return check;
}

// The forms of paper 003 with F fraction bits: the search of quad_drift over curves and roundings.
Check Quad(const UnitContract& unit, const std::string& form_name, int bits,
           const std::string& ulp) {
  Check check = Of(unit);
  check.ulp = ulp;
  check.narrowed = "registers of " + std::to_string(bits - 1) + " fraction bits";
  check.genes = {"seed of the search of curves and roundings"};
  check.cost = 40;
  check.blind = 0.9;
  for (const accuracy::DriftForm& form : accuracy::DriftForms()) {
    if (form.name != form_name) continue;
    check.error = [form, bits](const Genes& g, int narrow) {
      return accuracy::WorstDrift(form, bits - narrow, kLast,
                                  static_cast<unsigned>(std::ldexp(g[0], 20)));
    };
  }
  check.cost = 3000;
  return check;
}

Check Cosine() {
  Check check = Of(QuadCosine::kContract);
  check.ulp = "2^-30";
  check.narrowed = "seeds S1.43";
  check.genes = {"part of the start below an ulp", "of the difference", "of 2A", "2A"};
  check.error = [](const Genes& g, int narrow) {
    const Real unit = std::ldexp(1.0L, narrow - 44);
    const auto off = [&](Real v, double gene) {
      return (std::round(v / unit) + static_cast<Real>(Fraction(gene))) * unit;
    };
    const Real first = off(0.5L, g[0]), slope = off(-0.25L * g[3] / kLast, g[1]);
    const Real bend = off(0.5L * g[3] / kLast / kLast, g[2]);
    const auto seed = [&](Real v) { return CosineAcc::Wrap(RoundNarrow(v, 44, narrow)); };
    QuadCosine curve(CurveSeed{seed(first), {}, seed(slope), seed(bend)});
    for (int t = 0; t < kLast; ++t) curve.Step();
    const Real ideal = first + slope * kLast + bend * (kLast * (kLast - 1) / 2);
    return static_cast<double>(
        std::abs(static_cast<Real>(curve.value().raw()) - std::ldexp(ideal, 30)));
  };
  check.starts = {{0, 0, 0, 0.7}, {1, 1, 1, 0.7}};
  check.cost = 2;
  return check;
}

// Six coefficients, rounded: all that a form errs that evaluates every pixel anew.
Check Point(const UnitContract& unit) {
  Check check = Of(unit);
  check.ulp = "codes";
  check.narrowed = "coefficients S9.25";
  check.genes = {"part of A below an ulp", "of B", "of C", "of D", "of E", "of F", "x", "y"};
  check.error = [](const Genes& g, int narrow) {
    const Real x = std::round(Between(-2047, 2047, g[6])),
               y = std::round(Between(-2047, 2047, g[7]));
    const std::array<Real, 6> term = {x * x, y * y, x * y, x, y, 1};
    const Real ulp = std::ldexp(1.0L, narrow - 26);
    Real error = 0;
    for (size_t i = 0; i < term.size(); ++i) {
      const Real real = (static_cast<Real>(3 * i + 1) + Fraction(g[i])) * ulp;
      const Real rounded = std::ldexp(static_cast<Real>(RoundNarrow(real, 26, narrow)), -26);
      error += (rounded - real) * term[i];
    }
    return static_cast<double>(std::abs(error));
  };
  check.starts = {{0, 0, 0, 0, 0, 0, 1, 1}};
  return check;
}

}  // namespace

std::vector<Check> RecurrenceChecks() {
  std::vector<Check> checks = {Slerp(), Paper(), Linear(), Length(), Walker(), Gouraud()};
  checks.push_back(Quad(QuadSurface::kContract, "(5)", 26, "codes"));
  checks.push_back(Quad(QuadStep::kContract, "(3)", 26, "codes"));
  checks.push_back(Quad(QuadMidpoint::kContract, "(5)", 26, "codes"));
  checks.push_back(Quad(QuadThreeTerm::kContract, "(7)", 26, "codes"));
  checks.push_back(Quad(QuadThirdDifference::kContract, "(8)", 26, "codes"));
  checks.push_back(Quad(QuadSegment::kContract, "two registers, A", 26, "codes"));
  checks.push_back(Quad(QuadDifference::kContract, "two registers, 2A", 26, "codes"));
  checks.push_back(Cosine());
  checks.push_back(Point(QuadPolynomial::kContract));
  checks.push_back(Point(QuadHorner::kContract));
  return checks;
}

}  // namespace shading::stress
