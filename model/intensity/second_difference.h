// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/intensity/word.h"

namespace shading {

// Bit-exact model of rtl/intensity/second_difference.sv: a quadratic along a span.
//
//   v(t+1) = v(t) + d(t),  d(t+1) = d(t) + c
//
// The number stands at the top of the word: sums wrap as those of the registers do.
template <typename Word = uint64_t>
class SecondDifference {
 public:
  SecondDifference() : SecondDifference(Word(0), Word(0), Word(0)) {}
  template <typename Seed>
  explicit SecondDifference(const Seed& seed)
      : SecondDifference(ToWord<Word>(seed.first), ToWord<Word>(seed.difference),
                         ToWord<Word>(seed.curvature)) {}

  const Word& value() const { return value_; }
  void Step() {
    value_ = value_ + difference_;
    difference_ = difference_ + curvature_;
  }

 private:
  SecondDifference(Word value, Word difference, Word curvature)
      : value_(value), difference_(difference), curvature_(curvature) {}

  Word value_;       // v(t)
  Word difference_;  // v(t+1) - v(t)
  Word curvature_;   // c
};

}  // namespace shading
