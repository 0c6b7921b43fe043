// SPDX-License-Identifier: Apache-2.0
#include "sim/bench/ideal_cache.h"

#include <fmt/format.h>

namespace shading::sim {

PictureError IdealCache::ErrorOf(const CellKey& key, Method method, const FrameBuffer& picture,
                                 const TriangleList& list) {
  const Method form = ClosedFormOf(method);
  const std::string name = fmt::format("{} n={} {}", key.scene, key.shininess, Name(form));
  const std::shared_ptr<Entry> entry = EntryOf(name);
  std::shared_ptr<const IdealPicture> ideal;
  {
    const std::lock_guard<std::mutex> lock(entry->mutex);
    if (!entry->ideal) {
      entry->ideal = std::make_shared<const IdealPicture>(picture, list, form);
      Count(name, entry.get(), entry->ideal->bytes());
    }
    ideal = entry->ideal;
  }
  // Methods agree on what is seen, but for depths that are equal to the last bit.
  return ideal->Fits(picture) ? ideal->ErrorOf(picture)
                              : ErrorAgainstClosedForm(picture, list, form);
}

std::shared_ptr<IdealCache::Entry> IdealCache::EntryOf(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  recent_.remove(name);
  recent_.push_front(name);
  std::shared_ptr<Entry>& entry = entries_[name];
  if (!entry) entry = std::make_shared<Entry>();
  return entry;
}

void IdealCache::Count(const std::string& name, Entry* entry, size_t bytes) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++computed_;
  const auto at = entries_.find(name);
  if (at == entries_.end() || at->second.get() != entry) return;  // it went while it was computed
  entry->bytes = bytes;
  bytes_ += bytes;
  while (bytes_ > budget_ && recent_.size() > 1) {
    const auto oldest = entries_.find(recent_.back());
    bytes_ -= oldest->second->bytes;
    entries_.erase(oldest);
    recent_.pop_back();
  }
}

}  // namespace shading::sim
