// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <random>

#include "model/choice/choice_types.h"

namespace shading {

// Every field over its whole range, many near the places where something changes.
inline LightRange AnyRange(std::mt19937& random) {
  constexpr int64_t kOneCosine = int64_t{1} << RangeCosine::kFraction;
  const auto cosine = [&]() -> RangeCosine {
    const int64_t raw =
        static_cast<int64_t>(random() % (1u << RangeCosine::kWidth)) - 2 * kOneCosine;
    const int64_t near = static_cast<int64_t>(random() % 64) - 32;
    constexpr std::array<int64_t, 4> kPlaces = {0, kOneCosine / 2, kOneCosine, -kOneCosine};
    return RangeCosine::FromRaw(random() % 2 == 0 ? raw : kPlaces[random() % 4] + near);
  };
  LightRange range;
  range.turn = Turn::FromRaw(static_cast<int64_t>(random() % (1u << Turn::kWidth)) >>
                             (random() % Turn::kWidth));
  constexpr int64_t kOneTurn = int64_t{1} << Turn::kFraction;
  if (random() % 8 == 0) {
    const int64_t near = static_cast<int64_t>(random() % 3) - 1;
    range.turn = Turn::FromRaw((kOneTurn >> random() % 2 * 2) + near);
  }
  range.n_dot_l_low = cosine();
  range.n_dot_l_high = cosine();
  range.specular_low = cosine();
  range.specular_high = cosine();
  return range;
}

inline ChoiceLimit AnyLimit(std::mt19937& random) {
  const auto log = [&](int least, int most) {
    if (random() % 8 == 0) return kLogOfZero;
    if (random() % 32 == 0) return Log::FromRaw(random() % 2 == 0 ? 2047 : -2048);
    return Log::FromRaw(least + static_cast<int>(random() % static_cast<unsigned>(most - least)));
  };
  ChoiceLimit limit;
  limit.diffuse = log(-200, 640);
  limit.specular = log(-200, 640);
  limit.shininess_log = log(0, 257);
  limit.shininess = Shininess::FromRaw(static_cast<int64_t>(random() % 65536) >> random() % 16);
  limit.below_full = random() % 4 != 0;
  limit.below_full_dark = random() % 4 != 0;
  limit.channels = static_cast<uint8_t>(random() % 8);
  return limit;
}

}  // namespace shading
