// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <deque>
#include <random>

#include "model/flow_pattern.h"
#include "model/light/light_types.h"
#include "model/normal/normal_types.h"
#include "model/unit_contract.h"

namespace shading {

inline int64_t Bits64(std::mt19937& random) {
  return static_cast<int64_t>(static_cast<uint64_t>(random()) << 32 | random());
}

// A number of `width` bits whose magnitude is equally likely in every octave.
inline int64_t AnyOctave(int width, std::mt19937& random) {
  return Bits64(random) >> (64 - width + static_cast<int>(random() % static_cast<uint32_t>(width)));
}

// A component from the corners of S1.38, or of any magnitude.
inline Quantity AnyQuantity(std::mt19937& random) {
  constexpr int64_t kOne = int64_t{1} << Quantity::kFraction;
  const int64_t near = static_cast<int64_t>(random() % 5) - 2;
  switch (random() % 8) {
    case 0: return Quantity::Wrap(2 * kOne + near);
    case 1: return Quantity::Wrap(random() % 2 ? near : -kOne + near);
    case 2: return Quantity::Wrap(kOne + near);
    default: return Quantity::Wrap(AnyOctave(Quantity::kWidth, random));
  }
}

// A linear normal of the given length; a fifth of them lies on axes and diagonals.
inline std::array<Quantity, 3> NormalOf(double length, std::mt19937& random) {
  std::normal_distribution<double> gauss;
  std::array<double, 3> v = {gauss(random), gauss(random), gauss(random)};
  if (random() % 5 == 0) {
    for (double& c : v) c = static_cast<double>(random() % 3) - 1;
  }
  const double norm = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  std::array<Quantity, 3> normal;
  for (size_t i = 0; i < 3; ++i) normal[i] = Quantity::Round(norm > 0 ? v[i] / norm * length : 0);
  return normal;
}

// From 2^-9 to 1 + 2^-9, mostly near 1.
inline double RandomLength(double shortest, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform;
  const double u = uniform(random);
  switch (random() % 4) {
    case 0: return 1 + (u - 0.5) * std::ldexp(1, -8);
    case 1: return shortest;
    case 2: return shortest + u * (1 - shortest);
    default: return shortest * std::pow(1 / shortest, u);
  }
}

inline long double LengthOf(const std::array<Quantity, 3>& normal) {
  long double sum = 0;
  for (const Quantity c : normal) {
    const long double real = std::ldexp(static_cast<long double>(c.raw()), -Quantity::kFraction);
    sum += real * real;
  }
  return std::sqrt(sum);
}

// Sends `count` inputs through RTL and model. `offers` says in which cycles an input is valid; in
// the others the data pins carry noise. Outputs come exactly Latency cycles after their inputs.
template <typename Dut, typename Next, typename Model, typename Same>
void ExpectSameStream(const FlowPattern& offers, int count, Next next, Model model, Same same) {
  Dut rtl;
  using Output = decltype(rtl.output());
  std::deque<std::pair<int64_t, Output>> due;
  int64_t cycle = 0;
  for (int sent = 0, got = 0; got < count; ++cycle) {
    ASSERT_LT(cycle, int64_t{100} * count) << "deadline";
    const bool valid = sent < count && offers.At(cycle);
    const auto input = next();
    rtl.Cycle(valid, input);
    if (valid) due.emplace_back(cycle + Dut::kLatency - 1, model(input));
    sent += valid;
    const bool expected = !due.empty() && due.front().first == cycle;
    ASSERT_EQ(rtl.valid(), expected) << "cycle " << cycle;
    if (!expected) continue;
    ASSERT_TRUE(same(rtl.output(), due.front().second)) << "output " << got;
    due.pop_front();
    ++got;
  }
}

// Cycles from an input to its output; inputs in consecutive cycles all arrive.
template <typename Dut, typename Input>
void ExpectPipelineTiming(const UnitContract& contract, const Input& input) {
  EXPECT_EQ(Dut::kLatency, contract.latency_cycles);
  Dut rtl;
  EXPECT_FALSE(rtl.valid()) << "after reset";
  int cycles = 1;
  for (rtl.Cycle(true, input); !rtl.valid() && cycles < 64; ++cycles) rtl.Cycle(false, input);
  EXPECT_EQ(cycles, contract.latency_cycles);
  int seen = 0;
  for (int i = 0; i < 64 + cycles - 1; ++i) {
    rtl.Cycle(i < 64, input);
    seen += rtl.valid();
  }
  EXPECT_EQ(seen, 64 / contract.interval_cycles);
}

inline bool SameNormal(const PixelNormal& a, const PixelNormal& b) { return a == b; }

}  // namespace shading
