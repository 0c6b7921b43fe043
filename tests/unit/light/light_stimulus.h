// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <deque>
#include <random>

#include "model/light/light_types.h"
#include "tests/unit/flows.h"

namespace shading {

inline constexpr int64_t kOneCosine = int64_t{1} << Cosine::kFraction;
inline constexpr int64_t kLeastShininess = int64_t{1} << Shininess::kFraction;  // 1
inline constexpr int64_t kMostShininess = kLeastShininess << 8;                 // 256

// 1 - x down to 2^-30, equally likely in every octave; one in eight likewise above 0.
inline int64_t RandomPositive(std::mt19937& random) {
  const int64_t gap = static_cast<int64_t>(random() & (kOneCosine - 1)) >> (random() % 30);
  return random() % 8 == 0 ? gap : kOneCosine - gap;
}

// Any cosine: corners, all bits, and mostly what is visible.
inline Cosine RandomCosine(std::mt19937& random) {
  constexpr std::array<int64_t, 12> kCorners = {0,
                                                1,
                                                -1,
                                                kOneCosine - 1,
                                                kOneCosine,
                                                kOneCosine + 1,
                                                -kOneCosine,
                                                -kOneCosine - 1,
                                                2 * kOneCosine - 1,
                                                -2 * kOneCosine,
                                                kOneCosine / 2,
                                                kOneCosine / 2 + 1};
  switch (random() % 8) {
    case 0: return Cosine::FromRaw(kCorners[random() % kCorners.size()]);
    case 1: return Cosine::Wrap(static_cast<int64_t>(random()));
    case 2: return Cosine::FromRaw(-RandomPositive(random));
    case 3: return Cosine::FromRaw(kOneCosine + (random() % kOneCosine >> (random() % 30)));
    default: return Cosine::FromRaw(RandomPositive(random));
  }
}

// 1..256, with and without a fraction, the ends often.
inline Shininess RandomShininess(std::mt19937& random) {
  const int64_t span = kMostShininess - kLeastShininess;
  switch (random() % 4) {
    case 0: return Shininess::FromRaw(kLeastShininess + random() % 3);
    case 1: return Shininess::FromRaw(kMostShininess - random() % 3);
    case 2: return Shininess::FromRaw(kLeastShininess * (1 + random() % 256));
    default: return Shininess::FromRaw(kLeastShininess + random() % (span + 1));
  }
}

// 0..1, the ends often; `any` includes values over 1.
inline Reflectance RandomReflectance(std::mt19937& random, bool any = false) {
  constexpr int64_t kOne = int64_t{1} << Reflectance::kFraction;
  switch (random() % 8) {
    case 0: return Reflectance::FromRaw(0);
    case 1: return Reflectance::FromRaw(kOne);
    case 2: return Reflectance::FromRaw(any ? Reflectance::kMaxRaw - random() % 2 : 1);
    default: return Reflectance::FromRaw(random() % (kOne + 1));
  }
}

inline Material RandomMaterial(std::mt19937& random, bool any = false) {
  Material material;
  for (size_t c = 0; c < 3; ++c) {
    material.ambient[c] = RandomReflectance(random, any);
    material.diffuse[c] = RandomReflectance(random, any);
    material.specular[c] = RandomReflectance(random, any);
  }
  if (random() % 4 == 0) material.specular = {};
  material.shininess = RandomShininess(random);
  return material;
}

inline LightCosines RandomCosines(std::mt19937& random) {
  return {RandomCosine(random), RandomCosine(random)};
}

// Feeds `count` inputs in the willing cycles of the pattern, and noise in the others. Every output
// must come kLatency cycles after its input and equal the model's.
template <typename Dut, typename Next, typename Model>
void ExpectSameStream(Dut* dut, const FlowPattern& pattern, int count, Next next, Model model) {
  using Input = typename Dut::Input;
  struct Expected {
    bool valid;
    Input input;
  };
  std::deque<Expected> inside;
  int compared = 0;
  for (int64_t cycle = 0, sent = 0; compared < count; ++cycle) {
    const bool valid = sent < count && pattern.At(cycle);
    sent += valid;
    const Input input = next();
    dut->Cycle(valid, input);
    inside.push_back({valid, input});
    const bool due =
        inside.size() == static_cast<size_t>(Dut::kLatency) ? inside.front().valid : false;
    ASSERT_EQ(dut->valid(), due) << "cycle " << cycle;
    if (due) {
      ASSERT_TRUE(dut->output() == model(inside.front().input)) << "output " << compared;
      ++compared;
    }
    if (inside.size() == static_cast<size_t>(Dut::kLatency)) inside.pop_front();
  }
}

// The latency of the contract, one input a cycle, and a reset that empties the pipeline.
template <typename Dut>
void ExpectTiming(const UnitContract& contract, const typename Dut::Input& input) {
  EXPECT_EQ(contract.latency_cycles, Dut::kLatency);
  EXPECT_EQ(contract.interval_cycles, 1);
  Dut dut;
  EXPECT_FALSE(dut.valid());
  int cycles = 0;
  for (dut.Cycle(true, input), ++cycles; !dut.valid() && cycles < 100; ++cycles) {
    dut.Cycle(false, input);
  }
  EXPECT_EQ(cycles, Dut::kLatency);
  dut.Cycle(false, input);
  EXPECT_FALSE(dut.valid()) << "one output for one input";
  for (int k = 0; k < 2 * Dut::kLatency; ++k) {
    dut.Cycle(true, input);
    EXPECT_EQ(dut.valid(), k + 1 >= Dut::kLatency) << "interval 1";
  }
  dut.Reset();
  for (int k = 0; k < 2 * Dut::kLatency; ++k) {
    EXPECT_FALSE(dut.valid()) << "a reset leaves nothing behind";
    dut.Cycle(false, input);
  }
}

}  // namespace shading
