// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/model_value.h"
#include "sim/stress/narrow_recurrence.h"

namespace shading::stress {
namespace {

constexpr int kLast = 2047;  // the last of the pixels for which bounds are stated

// Turns of 0.001 .. 90 degrees in 2048 pixels.
Arc ArcOf(const Genes& g) {
  const Real turn = kPi / 180 * static_cast<Real>(Geometric(0.001, 90, g[0]));
  return {turn / kLast, 2 * kPi * static_cast<Real>(g[1]) - turn / 2};
}

Check Slerp() {
  Check check =
      CheckOf(SlerpRecurrence::kContract, "2^-28", "state S1.37, multiplier operand S1.27");
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
  Check check = CheckOf(SlerpPaper::kContract, "2^-38", "state and factors of 37 fraction bits");
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
  Check check = CheckOf(LinearRecurrence::kContract, "2^-38", "seeds S1.37");
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
  Check check = CheckOf(LengthRecurrence::kContract, "2^-44", "seeds S1.43");
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
  Check check = CheckOf(PixelWalker::kContract, "2^-24", "seeds S1.37");
  check.genes = {"part of the start below an ulp", "part of the slope", "slope, 0..1 a span"};
  check.error = [](const Genes& g, int narrow) {
    constexpr int kLastPixel = kMaxScreen - 1;
    const Real unit = std::ldexp(1.0L, narrow - 38);
    const Real first = 0.25L + Fraction(g[0]) * unit;
    const Real slope =
        (std::round(g[2] / 2 / kLastPixel / unit) + static_cast<Real>(Fraction(g[1]))) * unit;
    const int64_t at =
        DepthAfter(RoundNarrow(first, 38, narrow), RoundNarrow(slope, 38, narrow), kLastPixel);
    return static_cast<double>(std::ldexp(
        std::abs(std::ldexp(static_cast<Real>(at), -38) - first - slope * kLastPixel), 24));
  };
  check.starts = {{0, 0, 0.4}, {1, 1, 0.4}};
  check.cost = 60;
  return check;
}

Check Cosine() {
  Check check = CheckOf(QuadCosine::kContract, "2^-30", "seeds S1.43");
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

}  // namespace

std::vector<Check> RecurrenceChecks() {
  return {Slerp(), Paper(), Linear(), Length(), Walker(), Cosine()};
}

}  // namespace shading::stress
