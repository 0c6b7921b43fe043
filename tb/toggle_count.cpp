// SPDX-License-Identifier: Apache-2.0
#include "tb/toggle_count.h"

#include <gtkwave/fstapi.h>

#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace shading::tb {
namespace {

struct CloseReader {
  void operator()(void* reader) const { fstReaderClose(reader); }
};
using Reader = std::unique_ptr<void, CloseReader>;

// A signal of the waveform; those that are the same net share one.
struct Signal {
  bool counted = false;
  SignalToggles toggles;
  std::string value;  // the latest, a character a bit
};
using Signals = std::vector<Signal>;

bool EndsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

bool IsCounted(std::string_view name) {
  const std::string_view plain = name.substr(0, name.find_first_of(" ["));
  return !EndsWith(plain, "_i") && !EndsWith(plain, "_ni");
}

Signals ReadSignals(void* reader) {
  Signals signals;
  struct Scope {
    std::string path, unit;
    bool counted;  // a struct is a scope, too: an input's fields do not count
  };
  std::vector<Scope> scopes = {{"", "top", true}};
  while (const fstHier* item = fstReaderIterateHier(reader)) {
    const Scope& around = scopes.back();
    if (item->htyp == FST_HT_SCOPE) {
      const std::string name(item->u.scope.name, item->u.scope.name_length);
      const bool is_unit = name.rfind("u_", 0) == 0;
      scopes.push_back({around.path + name + ".", is_unit ? name.substr(2) : around.unit,
                        is_unit || (around.counted && IsCounted(name))});
    } else if (item->htyp == FST_HT_UPSCOPE) {
      scopes.pop_back();
    } else if (item->htyp == FST_HT_VAR) {
      const size_t handle = item->u.var.handle;
      if (signals.size() <= handle) signals.resize(handle + 1);
      const std::string name(item->u.var.name, item->u.var.name_length);
      if (signals[handle].counted || !around.counted || !IsCounted(name)) continue;
      signals[handle].counted = true;
      signals[handle].toggles = {around.path + name, around.unit, item->u.var.length, 0};
    }
  }
  return signals;
}

void Count(std::string_view value, Signal* signal) {
  if (!signal->counted) return;
  if (signal->value.size() == value.size()) {
    for (size_t i = 0; i < value.size(); ++i) {
      signal->toggles.toggles += signal->value[i] != value[i];
    }
  }
  signal->value = value;
}

void OnChange(void* signals, uint64_t, fstHandle handle, const unsigned char* value) {
  Count(reinterpret_cast<const char*>(value), &(*static_cast<Signals*>(signals))[handle]);
}
void OnLongChange(void* signals, uint64_t, fstHandle handle, const unsigned char* value,
                  uint32_t length) {
  Count({reinterpret_cast<const char*>(value), length}, &(*static_cast<Signals*>(signals))[handle]);
}

}  // namespace

std::vector<SignalToggles> CountToggles(const std::string& fst) {
  const Reader reader(fstReaderOpen(fst.c_str()));
  if (!reader) throw std::runtime_error(fst + ": not a waveform that can be read");
  Signals signals = ReadSignals(reader.get());
  fstReaderSetFacProcessMaskAll(reader.get());
  fstReaderIterBlocks2(reader.get(), OnChange, OnLongChange, &signals, nullptr);
  std::vector<SignalToggles> counts;
  for (Signal& signal : signals) {
    if (signal.counted) counts.push_back(std::move(signal.toggles));
  }
  return counts;
}

Toggles ByUnit(const std::vector<SignalToggles>& signals) {
  Toggles units;
  for (const SignalToggles& signal : signals) {
    units[signal.unit].bits += signal.bits;
    units[signal.unit].toggles += signal.toggles;
  }
  return units;
}

}  // namespace shading::tb
