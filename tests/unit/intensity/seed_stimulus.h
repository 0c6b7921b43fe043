// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "model/fixed/wide_integer.h"
#include "model/flow_pattern.h"
#include "model/shading_types.h"
#include "model/unit_contract.h"

namespace shading {

inline constexpr int64_t kOneCode = int64_t{1} << IntensityAcc::kFraction;
inline constexpr int64_t kHalfCode = kOneCode / 2;
inline constexpr int64_t kMostAcc = (int64_t{1} << (IntensityAcc::kWidth - 1)) - 1;
inline constexpr int64_t kLeastAcc = -kMostAcc - 1;

// Seeds of one channel from raw S9.26 numbers.
inline ChannelSeed SeedOf(int64_t first, int64_t second, int64_t difference, int64_t curvature) {
  return {IntensityAcc::FromRaw(first), IntensityAcc::FromRaw(second),
          IntensityAcc::FromRaw(difference), IntensityAcc::FromRaw(curvature)};
}

// The shortest and the longest spans are frequent.
inline int RandomLength(std::mt19937& random) {
  switch (random() % 16) {
    case 0: return kMaxScreen;
    case 1:
    case 2: return 1;
    case 3: return 2;
    case 4: return 3;
    case 5: return 1 + static_cast<int>(random() % kMaxScreen);
    default: return 1 + static_cast<int>(random() % 64);
  }
}

// Any S9.26: its extremes, the two sides of the clamps, or a value of random magnitude.
inline IntensityAcc RandomAcc(std::mt19937& random) {
  const int64_t near = static_cast<int64_t>(random() % 5) - 2;
  switch (random() % 8) {
    case 0: return IntensityAcc::Wrap(kMostAcc + near);
    case 1: return IntensityAcc::Wrap(near);
    case 2: return IntensityAcc::Wrap(256 * kOneCode + near);
    default: break;
  }
  const int64_t bits = static_cast<int64_t>(static_cast<uint64_t>(random()) << 32 | random());
  return IntensityAcc::Wrap(bits >> (28 + random() % 36));
}

// Either four unrelated numbers, whose recurrences wrap, or a curve that moves through the codes
// within the span.
inline ChannelSeed RandomSeed(int length, std::mt19937& random) {
  if (random() % 2) {
    return {RandomAcc(random), RandomAcc(random), RandomAcc(random), RandomAcc(random)};
  }
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto round = [](double codes) {
    return IntensityAcc::Wrap(std::llround(std::ldexp(codes, IntensityAcc::kFraction)));
  };
  const double first = 128 + 200 * unit(random), difference = 400 * unit(random) / length;
  const double curvature = 800 * unit(random) / length / length;
  return {round(first), round(first + difference), round(difference), round(curvature)};
}

// The code of an accumulator that was formed without a register: wraps, truncates, clamps.
inline uint8_t CodeOf(Int128 accumulator) {
  const Int128 turn = Int128{1} << IntensityAcc::kWidth;
  Int128 wrapped = accumulator - turn * FloorDivide<Int128>(accumulator, turn);
  if (wrapped >= turn / 2) wrapped -= turn;
  const Int128 whole = FloorDivide<Int128>(wrapped, kOneCode);
  return static_cast<uint8_t>(whole < 0 ? 0 : whole > Code::kMaxRaw ? Code::kMaxRaw : whole);
}

// Marches spans through RTL and model. The pattern says in which cycles the next pixel is wanted;
// in the others the code must hold. The seed port carries noise except when it is loaded, and the
// step pin does so then.
template <typename Model, typename Dut>
void ExpectSameCodes(const FlowPattern& steps, int spans, uint32_t random_seed) {
  SCOPED_TRACE("random seed " + std::to_string(random_seed));
  std::mt19937 random(random_seed);
  Dut rtl;
  int64_t cycle = 0;
  for (int span = 0; span < spans; ++span) {
    const int length = RandomLength(random);
    const ChannelSeed seed = RandomSeed(length, random);
    Model model(seed);
    rtl.Cycle(true, random() % 2, seed);
    ASSERT_EQ(rtl.code(), model.code()) << "first pixel of span " << span;
    const int idle = random() % 2 ? 0 : static_cast<int>(random() % 4);
    for (int left = length - 1 + idle; left > 0; ++cycle) {
      const bool step = left > idle && steps.At(cycle);
      const ChannelSeed noise = {RandomAcc(random), RandomAcc(random), RandomAcc(random),
                                 RandomAcc(random)};
      rtl.Cycle(false, step, noise);
      if (step) model.Step();
      if (step || left <= idle) --left;
      ASSERT_EQ(rtl.code(), model.code())
          << "span " << span << " of " << length << " pixels, " << left - idle << " left";
    }
  }
}

// Cycles from the load to the code, and cycles between two loads that both arrive. `seeds` give
// different codes.
template <typename Dut>
void ExpectTiming(const UnitContract& contract, const ChannelSeed& one, const ChannelSeed& two) {
  EXPECT_EQ(Dut::kLatency, contract.latency_cycles);
  Dut rtl;
  rtl.Cycle(true, false, one);
  const uint8_t before = rtl.code();
  int cycles = 1;
  rtl.Cycle(true, false, two);
  while (rtl.code() == before && cycles < 8) {
    rtl.Cycle(false, false, one);
    ++cycles;
  }
  EXPECT_EQ(cycles, contract.latency_cycles);

  int seen = 0;
  for (int load = 0; load < 8; ++load) {
    rtl.Cycle(true, true, load % 2 ? two : one);
    seen += rtl.code() == (load % 2 ? CodeOf(two.first.raw()) : CodeOf(one.first.raw()));
  }
  EXPECT_EQ(seen, 8 / contract.interval_cycles);
}

}  // namespace shading
