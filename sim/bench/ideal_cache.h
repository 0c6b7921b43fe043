// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "sim/bench/bench_cell.h"
#include "sim/picture_error.h"

namespace shading::sim {

// Closed forms by scene, n and form: methods, tolerances and lanes share them. Those that were not
// asked for longest go when all take more than the budget. Thread-safe.
class IdealCache {
 public:
  explicit IdealCache(size_t budget_bytes = size_t{256} << 20) : budget_(budget_bytes) {}

  // Of a picture of the list against the closed form of a method; the key says which scene and n.
  PictureError ErrorOf(const CellKey& key, Method method, const FrameBuffer& picture,
                       const TriangleList& list);
  int computed() const { return computed_; }  // closed forms of whole pictures

 private:
  struct Entry {
    std::mutex mutex;
    std::shared_ptr<const IdealPicture> ideal;  // by `mutex`
    size_t bytes = 0;                           // by that of the cache; 0 until it is computed
  };
  std::shared_ptr<Entry> EntryOf(const std::string& name);
  void Count(const std::string& name, Entry* entry, size_t bytes);

  const size_t budget_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Entry>> entries_;
  std::list<std::string> recent_;  // the latest first
  size_t bytes_ = 0;
  int computed_ = 0;
};

}  // namespace shading::sim
