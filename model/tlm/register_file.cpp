// SPDX-License-Identifier: Apache-2.0
#include "model/tlm/register_file.h"

#include <algorithm>

namespace shading {

RegisterFile::RegisterFile()
    : rows_(kAddressSpace / kWordBytes, nullptr), words_(kAddressSpace / kWordBytes) {
  for (const Register& row : kRegisterMap) {
    std::fill_n(rows_.begin() + row.offset / kWordBytes, row.words, &row);
  }
  Reset();
}

void RegisterFile::Reset() {
  std::fill(words_.begin(), words_.end(), 0u);
  for (const Register& row : kRegisterMap) Set(row.offset, row.reset);
}

}  // namespace shading
