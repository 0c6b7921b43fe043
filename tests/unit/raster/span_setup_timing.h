// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "model/raster/span_setup.h"
#include "tb/dut/span_setup_dut.h"

namespace shading {

// What span_inside_o and busy_o must be, from (after, until] intervals.
struct Occupancy {
  std::vector<bool> inside, busy;
  explicit Occupancy(size_t cycles) : inside(cycles), busy(cycles) {}
  void Span(int64_t accepted, int64_t taken) {
    for (int64_t c = accepted + 1; c <= taken; ++c) inside[static_cast<size_t>(c)] = true;
    Triangle(accepted, taken);
  }
  void Triangle(int64_t taken, int64_t released) {
    for (int64_t c = taken + 1; c <= released; ++c) busy[static_cast<size_t>(c)] = true;
  }
};

// Cycles in which all stops, because a sum waits for the seed register.
class Blocked {
 public:
  void Add(int64_t from, int64_t until) { intervals_.push_back({from, until}); }
  // The cycle in which `steps` cycles behind `cycle` have gone on.
  int64_t After(int64_t cycle, int steps) const {
    for (; steps > 0; --steps) {
      ++cycle;
      while (Holds(cycle)) ++cycle;
    }
    return cycle;
  }

 private:
  bool Holds(int64_t cycle) const {
    const size_t first = intervals_.size() > 2 ? intervals_.size() - 2 : 0;
    for (size_t i = first; i < intervals_.size(); ++i) {
      if (cycle >= intervals_[i].first && cycle < intervals_[i].second) return true;
    }
    return false;
  }

  std::vector<std::pair<int64_t, int64_t>> intervals_;  // [from, until)
};

// Exact cycles of every command and seed: a stage starts when its input is there, the stage is free
// and there is room downstream.
inline void ExpectCycles(const tb::SpanSetupDut::Work& work, const tb::SpanSetupDut::Flows& flows,
                         const tb::SpanSetupDut::Result& result) {
  Occupancy occupancy(result.busy.size());
  int64_t triangle_taken = flows.triangle.Next(0), released = 0;
  int64_t accepted = -1, last_step = 0, seed_taken = 0;
  Blocked blocked;
  size_t triangle = 0;
  int row = work.triangles[0].origin_y;
  for (size_t i = 0; i < work.spans.size(); ++i) {
    ASSERT_EQ(result.triangles[triangle], triangle_taken) << "triangle " << triangle;
    accepted = std::max({flows.span.Next(accepted + 1), triangle_taken, last_step});
    ASSERT_EQ(result.spans[i], accepted) << "span " << i;
    const int steps = SpanSetup::Steps(work.Of(triangle).method, work.spans[i].y - row);
    row = work.spans[i].y;
    last_step = blocked.After(accepted, steps);
    const int64_t finish = blocked.After(last_step, 1);
    const int64_t sum = std::max(finish + 1, seed_taken);
    blocked.Add(finish + 1, sum);
    ASSERT_EQ(result.seeds[i].offered, sum + 1) << "span " << i;
    seed_taken = flows.seed.Next(sum + 1);
    ASSERT_EQ(result.seeds[i].taken, seed_taken) << "span " << i;
    occupancy.Span(accepted, seed_taken);
    if (!work.spans[i].last) continue;
    released = last_step;
    occupancy.Triangle(triangle_taken, released);
    ++triangle;
    if (triangle < work.triangles.size()) row = work.triangles[triangle].origin_y;
    triangle_taken = std::max(flows.triangle.Next(triangle_taken + 1), released);
  }
  EXPECT_EQ(result.inside, occupancy.inside);
  EXPECT_EQ(result.busy, occupancy.busy);
}

}  // namespace shading
