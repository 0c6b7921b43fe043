// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "model/tlm/register_map.h"

namespace shading {

// The words behind the register map. Offsets are in bytes, multiples of 4 inside the address space.
class RegisterFile {
 public:
  RegisterFile();

  // Every word to its reset value.
  void Reset();

  // The row at this offset, or nullptr where nothing is mapped.
  const Register* Find(uint64_t offset) const {
    return offset < kAddressSpace ? rows_[offset / kWordBytes] : nullptr;
  }

  uint32_t Get(uint32_t offset) const { return words_[offset / kWordBytes]; }
  void Set(uint32_t offset, uint32_t value) { words_[offset / kWordBytes] = value; }

  // 64-bit registers: low word first.
  uint64_t Get64(uint32_t offset) const {
    return Get(offset) | static_cast<uint64_t>(Get(offset + kWordBytes)) << 32;
  }
  void Set64(uint32_t offset, uint64_t value) {
    Set(offset, static_cast<uint32_t>(value));
    Set(offset + kWordBytes, static_cast<uint32_t>(value >> 32));
  }

  const uint32_t* data(uint32_t offset) const { return &words_[offset / kWordBytes]; }

 private:
  std::vector<const Register*> rows_;  // of every word
  std::vector<uint32_t> words_;
};

}  // namespace shading
