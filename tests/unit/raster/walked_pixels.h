// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "model/fixed/wide_integer.h"
#include "model/flow_pattern.h"
#include "model/raster/pixel_walker.h"

namespace shading {

inline constexpr int64_t kOneDepth = int64_t{1} << DepthAcc::kFraction;  // z = 1
inline constexpr int64_t kUlp = kOneDepth >> Depth::kFraction;           // of U0.24

inline SpanSeed RunOf(int x, int y, int length, int64_t z, int64_t dz_dx) {
  SpanSeed run;
  run.x = x;
  run.y = y;
  run.length = length;
  run.z = DepthAcc::Wrap(z);
  run.dz_dx = DepthAcc::Wrap(dz_dx);
  return run;
}

// z(i) of a run, without a recurrence and without a register that could wrap.
inline Int128 ClosedForm(const SpanSeed& run, int i) {
  return run.z.raw() + static_cast<Int128>(run.dz_dx.raw()) * i;
}

// Truncates and clamps a depth that was formed without a register, after its wrap.
inline uint32_t DepthOf(Int128 accumulator) {
  const int64_t z = DepthAcc::Wrap(static_cast<int64_t>(accumulator)).raw();
  const int64_t whole = FloorDivide(z, kUlp);
  return static_cast<uint32_t>(std::clamp<int64_t>(whole, 0, Depth::kMaxRaw));
}

// Short and longest runs, whole-screen offsets, depths of any magnitude: the extremes wrap.
inline SpanSeed RandomRun(std::mt19937& random) {
  const auto acc = [&] {
    const int64_t bits = static_cast<int64_t>(static_cast<uint64_t>(random()) << 32 | random());
    return bits >> (24 + random() % 40);
  };
  const int kind = static_cast<int>(random() % 32);
  const int any = 1 + static_cast<int>(random() % 64);
  const int length = kind == 0 ? kMaxScreen : kind < 12 ? 1 + kind % 3 : any;
  const int x = static_cast<int>(random() % static_cast<uint32_t>(kMaxScreen - length + 1));
  return RunOf(x, static_cast<int>(random() % kMaxScreen), length, acc(), acc());
}

inline std::vector<SpanSeed> RandomRuns(int count, uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<SpanSeed> runs;
  for (int i = 0; i < count; ++i) runs.push_back(RandomRun(random));
  return runs;
}

inline int Groups(const SpanSeed& run, int lanes) { return (run.length + lanes - 1) / lanes; }

// Lane j of a group holds the next pixel but j; lanes after the last pixel of the run are masked.
template <typename Group>
void ExpectGroup(const Group& group, int first, int length, PixelWalker* model) {
  for (size_t j = 0; j < group.lane.size(); ++j) {
    const int pixel = first + static_cast<int>(j);
    ASSERT_EQ(group.mask >> j & 1, pixel < length) << "pixel " << pixel << " of " << length;
    ASSERT_EQ(group.lane[j].last, pixel + 1 == length);
    if (pixel >= length) continue;
    ASSERT_EQ(group.lane[j].x, model->x()) << "pixel " << pixel << " of " << length;
    ASSERT_EQ(group.lane[j].y, model->y());
    ASSERT_EQ(group.lane[j].z, model->z()) << "pixel " << pixel << " of " << length;
    model->Step();
  }
}

template <typename Result>
void ExpectPixels(const std::vector<SpanSeed>& runs, const Result& result) {
  ASSERT_EQ(result.failure, "");
  auto group = result.groups.begin();
  for (const SpanSeed& run : runs) {
    const int lanes = static_cast<int>(group->lane.size());
    PixelWalker model(run);
    for (int i = 0; i < run.length; i += lanes, ++group) {
      ASSERT_NE(group, result.groups.end());
      ASSERT_NO_FATAL_FAILURE(ExpectGroup(*group, i, run.length, &model));
      ASSERT_EQ(group->step, i + lanes < run.length) << "the intensity units lose the walker";
    }
  }
  EXPECT_EQ(group, result.groups.end()) << "more pixels than ordered";
  EXPECT_EQ(result.loads, result.taken);
  EXPECT_EQ(result.stray_steps, 0);
}

// A run is taken as soon as it is on offer and the last group of the run before leaves; its groups
// leave one per willing cycle of the sink, from the next cycle on.
template <typename Result>
void ExpectCycles(const std::vector<SpanSeed>& runs, const FlowPattern& source,
                  const FlowPattern& sink, int lanes, const Result& result) {
  int64_t taken = -1, last_left = 0, offers = 0;
  size_t index = 0;
  for (size_t run = 0; run < runs.size(); ++run) {
    taken = std::max(source.Next(taken + 1), last_left);
    ASSERT_EQ(result.taken[run], taken) << "run " << run;
    int64_t cycle = taken;
    for (int i = 0; i < Groups(runs[run], lanes); ++i) {
      cycle = sink.Next(cycle + 1);
      ASSERT_EQ(result.groups[index++].cycle, cycle) << "run " << run << " group " << i;
    }
    last_left = cycle;
    offers += last_left - taken;
  }
  EXPECT_EQ(static_cast<int64_t>(result.offers.size()), offers) << "valid waits for ready";
}

template <typename Build>
void ExpectWalk(const std::vector<SpanSeed>& runs, const FlowPattern& source,
                const FlowPattern& sink) {
  Build rtl;
  const auto result = rtl.Run(runs, source, sink);
  ASSERT_NO_FATAL_FAILURE(ExpectPixels(runs, result));
  ExpectCycles(runs, source, sink, Build::kLaneCount, result);
}

}  // namespace shading
