// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include "model/flow_pattern.h"
#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

using Real = long double;

inline constexpr Real kQuarterTurn = 1.57079632679489661923132169163975144L;
inline constexpr int64_t kOneQuantity = int64_t{1} << Quantity::kFraction;

inline Quantity RoundQuantity(Real value) {
  return Quantity::Wrap(std::llround(std::ldexp(value, Quantity::kFraction)));
}
inline Real ToReal(Quantity value) {
  return std::ldexp(static_cast<Real>(value.raw()), -Quantity::kFraction);
}

// 4 sin^2(angle / 2), rounded to nearest; saturates just below 2 (90 degrees).
inline Kappa KappaOf(Real angle) {
  const Real half = std::sin(angle / 2), kappa = 4 * half * half;
  int exponent = kMaxKappaExponent;
  while (exponent > 0 && std::ldexp(kappa, 2 * exponent) > 1) --exponent;
  const int64_t mantissa = std::llround(std::ldexp(kappa, 28 + 2 * exponent));
  return {U<1, 28>::Saturate(mantissa), exponent};
}

// What the recurrences start from; units take the fields they need.
struct QuantityStart {
  std::array<QuantitySeed, kMaxLanes> seed;
  std::array<Kappa, 2> step_kappa;
};

// s(t) = cos(start + t phi): any sine of amplitude 1, as a component of a turning unit vector is.
struct Arc {
  Real phi, start;

  Real At(int t) const { return std::cos(start + phi * t); }
  QuantitySeed Seed(int t, int stride) const {
    const Real difference =
        -2 * std::sin(start + phi * (t + stride / 2.0L)) * std::sin(phi * stride / 2);
    return {RoundQuantity(At(t)), RoundQuantity(difference)};
  }
  QuantityStart Start(int stride = 1) const {
    QuantityStart begin;
    for (int j = 0; j < kMaxLanes; ++j) begin.seed[static_cast<size_t>(j)] = Seed(j, stride);
    begin.step_kappa = {KappaOf(phi), KappaOf(2 * phi)};
    return begin;
  }
};

// Turns 1e-4 .. 90 degrees in `length` pixels, small angles as often as large ones; a third of the
// arcs start where the quantity is near 1 and hardly moves.
inline Arc RandomArc(int length, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  const Real turn = kQuarterTurn * std::pow(10.0L, -5.9543L * unit(random));
  const Real start = random() % 3 ? 4 * kQuarterTurn * unit(random) : -turn * unit(random);
  return {turn / std::max(1, length - 1), start};
}

// The shortest and the longest spans are frequent.
inline int RandomSpanLength(std::mt19937& random) {
  switch (random() % 16) {
    case 0: return 4096;
    case 1:
    case 2: return 1;
    case 3: return 2;
    case 4: return 3;
    case 5: return 1 + static_cast<int>(random() % 4096);
    default: return 1 + static_cast<int>(random() % 64);
  }
}

// Any S1.38: its extremes, neighbours of 0 and 1, or a value of random magnitude.
inline Quantity RandomQuantity(std::mt19937& random) {
  const int64_t near = static_cast<int64_t>(random() % 1029) - 514;  // around a rounding step
  switch (random() % 8) {
    case 0: return Quantity::Wrap(2 * kOneQuantity + near);
    case 1: return Quantity::Wrap(near);
    case 2: return Quantity::Wrap(kOneQuantity + near);
    default: break;
  }
  const int64_t bits = static_cast<int64_t>(static_cast<uint64_t>(random()) << 32 | random());
  return Quantity::Wrap(bits >> (24 + random() % 40));
}

// Exponents above 10 never occur on a span; RTL and model agree on them too.
inline Kappa RandomKappa(std::mt19937& random) {
  const int exponent = static_cast<int>(random() % (random() % 4 ? 11 : 16));
  const int64_t most = U<1, 28>::kMaxRaw;
  switch (random() % 8) {
    case 0: return {U<1, 28>::FromRaw(most - static_cast<int64_t>(random() % 4)), exponent};
    case 1: return {U<1, 28>::FromRaw(static_cast<int64_t>(random() % 4)), exponent};
    case 2: return {U<1, 28>::FromRaw(int64_t{1} << 28), exponent};
    default: return {U<1, 28>::FromRaw(static_cast<int64_t>(random() >> 3)), exponent};
  }
}

// Either unrelated numbers, whose recurrences wrap, or an arc.
inline QuantityStart RandomStart(int length, std::mt19937& random) {
  if (random() % 2) return RandomArc(length, random).Start(random() % 2 ? 1 : 4);
  QuantityStart start;
  for (QuantitySeed& seed : start.seed) seed = {RandomQuantity(random), RandomQuantity(random)};
  for (Kappa& kappa : start.step_kappa) kappa = RandomKappa(random);
  return start;
}

// A Bench names Model, Dut and kLanes, and has Make(start) -> Model, Cycle(dut, load, step, start),
// and Value(model or dut, lane).
template <typename Bench>
void ExpectSameLanes(typename Bench::Dut& rtl, const typename Bench::Model& model) {
  for (int lane = 0; lane < Bench::kLanes; ++lane) {
    ASSERT_EQ(Bench::Value(rtl, lane).raw(), Bench::Value(model, lane).raw()) << "lane " << lane;
  }
}

// Marches spans through RTL and model. The pattern says in which cycles the next pixel is wanted;
// in the others the value must hold. The seed port carries noise except when it is loaded, and the
// step pin does so then.
template <typename Bench>
void ExpectSameValues(const FlowPattern& steps, int spans, uint32_t random_seed) {
  SCOPED_TRACE("random seed " + std::to_string(random_seed));
  std::mt19937 random(random_seed);
  typename Bench::Dut rtl;
  int64_t cycle = 0;
  for (int span = 0; span < spans; ++span) {
    const int length = RandomSpanLength(random);
    SCOPED_TRACE("span " + std::to_string(span) + " of " + std::to_string(length) + " steps");
    const QuantityStart start = RandomStart(length, random), noise = RandomStart(1, random);
    typename Bench::Model model = Bench::Make(start);
    Bench::Cycle(rtl, true, random() % 2, start);
    ASSERT_NO_FATAL_FAILURE(ExpectSameLanes<Bench>(rtl, model));
    const int idle = random() % 2 ? 0 : static_cast<int>(random() % 4);
    for (int left = length - 1 + idle; left > 0; ++cycle) {
      const bool step = left > idle && steps.At(cycle);
      Bench::Cycle(rtl, false, step, noise);
      if (step) model.Step();
      if (step || left <= idle) --left;
      ASSERT_NO_FATAL_FAILURE(ExpectSameLanes<Bench>(rtl, model)) << left - idle << " left";
    }
  }
}

// Cycles from the load to the value, and loads in a row that all arrive.
template <typename Bench>
void ExpectTiming(const UnitContract& contract) {
  EXPECT_EQ(Bench::Dut::kLatency, contract.latency_cycles);
  const QuantityStart one = Arc{0.01L, 0.2L}.Start(), two = Arc{0.02L, 0.7L}.Start();
  typename Bench::Dut rtl;
  Bench::Cycle(rtl, true, false, one);
  const Quantity before = Bench::Value(rtl, 0);
  int cycles = 1;
  Bench::Cycle(rtl, true, false, two);
  while (Bench::Value(rtl, 0) == before && cycles < 8) {
    Bench::Cycle(rtl, false, false, one);
    ++cycles;
  }
  EXPECT_EQ(cycles, contract.latency_cycles);

  int seen = 0;
  for (int load = 0; load < 8; ++load) {
    const QuantityStart& start = load % 2 ? two : one;
    Bench::Cycle(rtl, true, true, start);
    seen += Bench::Value(rtl, 0) == Bench::Value(Bench::Make(start), 0);
  }
  EXPECT_EQ(seen, 8 / contract.interval_cycles);
}

// Load wins over step, and without either the value holds.
template <typename Bench>
void ExpectLoadWinsAndIdleHolds() {
  const QuantityStart start = Arc{0.01L, 0.2L}.Start(), noise = Arc{0.3L, 2.0L}.Start();
  typename Bench::Dut rtl;
  typename Bench::Model model = Bench::Make(start);
  Bench::Cycle(rtl, true, true, start);
  ExpectSameLanes<Bench>(rtl, model);
  Bench::Cycle(rtl, false, false, noise);
  ExpectSameLanes<Bench>(rtl, model);
  Bench::Cycle(rtl, false, true, noise);
  model.Step();
  ExpectSameLanes<Bench>(rtl, model);
  Bench::Cycle(rtl, true, true, noise);
  ExpectSameLanes<Bench>(rtl, Bench::Make(noise));
}

}  // namespace shading
