// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace shading::accuracy {

struct Operations {
  int multiplications = 0;
  int additions = 0;       // and subtractions
  int shifts = 0;          // by any number of bits
  int one_bit_shifts = 0;  // the same, a shift by n bits as n of them

  friend Operations operator-(const Operations& a, const Operations& b) {
    return {a.multiplications - b.multiplications, a.additions - b.additions, a.shifts - b.shifts,
            a.one_bit_shifts - b.one_bit_shifts};
  }
  friend bool operator==(const Operations& a, const Operations& b) {
    return a.multiplications == b.multiplications && a.additions == b.additions &&
           a.shifts == b.shifts && a.one_bit_shifts == b.one_bit_shifts;
  }
};

// A word of the second-order units that counts what is done with words of its kind. The count is
// that of the thread: take differences of it.
class CountedWord {
 public:
  explicit CountedWord(uint64_t bits) : bits_(bits) {}

  static const Operations& Total() { return Count(); }
  uint64_t bits() const { return bits_; }

  friend CountedWord operator*(const CountedWord& a, const CountedWord& b) {
    ++Count().multiplications;
    return CountedWord(a.bits_ * b.bits_);
  }
  friend CountedWord operator+(const CountedWord& a, const CountedWord& b) {
    ++Count().additions;
    return CountedWord(a.bits_ + b.bits_);
  }
  friend CountedWord operator-(const CountedWord& a, const CountedWord& b) {
    ++Count().additions;
    return CountedWord(a.bits_ - b.bits_);
  }
  friend CountedWord operator<<(const CountedWord& word, int bits) {
    CountShift(bits);
    return CountedWord(word.bits_ << bits);
  }
  friend CountedWord operator>>(const CountedWord& word, int bits) {
    CountShift(bits);
    return CountedWord(word.bits_ >> bits);
  }
  friend uint64_t Bits(const CountedWord& word) { return word.bits_; }

 private:
  static Operations& Count() {
    thread_local Operations count;
    return count;
  }
  static void CountShift(int bits) {
    ++Count().shifts;
    Count().one_bit_shifts += bits;
  }

  uint64_t bits_;
};

}  // namespace shading::accuracy
