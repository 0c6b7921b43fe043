// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "model/fixed/fixed.h"
#include "model/fixed/wide_integer.h"

namespace shading::tb {

// Fills a Verilated packed-struct port of up to `kWords` 32-bit words. The LAST field of the struct
// holds the lowest bits, so fields are put in reverse order of their declaration.
template <int kWords>
class BitPacker {
 public:
  void Put(int64_t value, int width) {
    const uint64_t bits = static_cast<uint64_t>(value) & ((uint64_t{1} << width) - 1);
    const int word = position_ / 32, shift = position_ % 32;
    const Uint128 wide = static_cast<Uint128>(bits) << shift;
    for (int i = 0; i < 3 && word + i < kWords; ++i) {
      words_[word + i] |= static_cast<uint32_t>(wide >> (32 * i));
    }
    position_ += width;
  }
  template <int I, int F>
  void Put(S<I, F> value) {
    Put(value.raw(), S<I, F>::kWidth);
  }
  template <typename Port>
  void Store(Port& port) const {
    static_assert(sizeof(Port) == kWords * sizeof(uint32_t), "the port has another width");
    for (int i = 0; i < kWords; ++i) port[i] = words_[i];
  }

  int width() const { return position_; }

 private:
  uint32_t words_[kWords] = {};
  int position_ = 0;
};

// Reads a Verilated packed-struct port, the last field first.
template <typename Port>
class BitReader {
 public:
  explicit BitReader(const Port& port) : port_(port) {}

  uint64_t Take(int width) {
    uint64_t bits = 0;
    for (int got = 0; got < width;) {
      const int word = position_ / 32, shift = position_ % 32;
      const int take = 32 - shift < width - got ? 32 - shift : width - got;
      const uint64_t mask = (uint64_t{1} << take) - 1;
      bits |= ((static_cast<uint64_t>(port_[word]) >> shift) & mask) << got;
      got += take;
      position_ += take;
    }
    return bits;
  }
  template <typename Fixed>
  Fixed TakeSigned() {
    return Fixed::Wrap(static_cast<int64_t>(Take(Fixed::kWidth)));
  }

 private:
  const Port& port_;
  int position_ = 0;
};

}  // namespace shading::tb
