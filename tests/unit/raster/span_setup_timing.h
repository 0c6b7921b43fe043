// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
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

// Exact cycles of every command and seed: a stage starts when its input is there, the stage is free
// and there is room downstream.
inline void ExpectCycles(const tb::SpanSetupDut::Work& work, const tb::SpanSetupDut::Flows& flows,
                         const tb::SpanSetupDut::Result& result) {
  Occupancy occupancy(result.busy.size());
  int64_t triangle_taken = flows.triangle.Next(0), released = 0;
  int64_t accepted = -1, last_step = 0, sum = 0, seed_taken = 0;
  size_t triangle = 0;
  int row = work.triangles[0].origin_y;
  for (size_t i = 0; i < work.spans.size(); ++i) {
    ASSERT_EQ(result.triangles[triangle], triangle_taken) << "triangle " << triangle;
    accepted = std::max({flows.span.Next(accepted + 1), triangle_taken, last_step});
    ASSERT_EQ(result.spans[i], accepted) << "span " << i;
    const int steps = SpanSetup::Steps(work.method, work.spans[i].y - row);
    row = work.spans[i].y;
    last_step = std::max(accepted + 1, sum) + steps - 1;
    sum = std::max(last_step + 1, seed_taken);
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
