// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/shading_types.h"

namespace shading {

// The second-order units are templates over the word that their registers hold: uint64_t, or a
// class of the caller that wraps a uint64_t and counts its operations (+, -, *, <<, >>). Such a
// class has an explicit constructor from uint64_t and overloads Bits in its own namespace.
// A register stands at the top of the word, where sums wrap as those of the register do.

// What a word holds, for the display; not an operation of the recurrence.
constexpr uint64_t Bits(const uint64_t& word) { return word; }

template <typename Word, typename Value>
constexpr Word ToWord(Value value) {
  return Word(Align(value));
}

}  // namespace shading
