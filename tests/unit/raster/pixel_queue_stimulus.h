// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "model/raster/pixel_queue.h"
#include "tb/dut/pixel_queue_dut.h"

namespace shading {

// Groups and when they come. The light is a first-in first-out pipeline: the cosines of a group
// come `cosines` cycles after it entered, its codes `light` cycles after, if those before are
// through.
template <int kLanes>
struct QueuePlan {
  std::vector<tb::PixelGroup<kLanes>> groups;
  std::vector<int> gap;      // cycles between the entry of the group before and its offer
  std::vector<int> cosines;  // 0..light - 1
  std::vector<int> light;    // 1..

  size_t size() const { return groups.size(); }
};

// Any bits: what is not in the mask is noise that must not show.
template <int kLanes>
tb::PixelGroup<kLanes> RandomGroup(std::mt19937& random) {
  tb::PixelGroup<kLanes> group;
  for (Pixel& pixel : group.pixel) {
    pixel.x = static_cast<uint16_t>(random() % kMaxScreen);
    pixel.y = static_cast<uint16_t>(random() % kMaxScreen);
    pixel.z = static_cast<uint32_t>(random()) & Depth::kMaxRaw;
    const auto rgb = static_cast<uint32_t>(random());
    pixel.r = static_cast<uint8_t>(rgb);
    pixel.g = static_cast<uint8_t>(rgb >> 8);
    pixel.b = static_cast<uint8_t>(rgb >> 16);
    pixel.last = rgb >> 24 & 1;
  }
  const uint32_t lanes = 1 + static_cast<uint32_t>(random()) % kLanes;
  group.mask = (1u << lanes) - 1;
  group.material = static_cast<int>(random() % 256);
  group.unlit = static_cast<uint32_t>(random()) & ((1u << kLanes) - 1);
  group.no_highlight = static_cast<uint32_t>(random()) & ((1u << kLanes) - 1);
  return group;
}

// A plan without gaps, through a light of fixed length.
template <int kLanes>
QueuePlan<kLanes> SteadyPlan(size_t groups, int cosines, int light, uint32_t seed) {
  std::mt19937 random(seed);
  QueuePlan<kLanes> plan;
  for (size_t g = 0; g < groups; ++g) plan.groups.push_back(RandomGroup<kLanes>(random));
  plan.gap.assign(groups, 0);
  plan.cosines.assign(groups, cosines);
  plan.light.assign(groups, light);
  return plan;
}

// Plays a plan. In every cycle it holds all outputs against the groups that are inside, and keeps
// the cycles of what happened.
template <typename Dut>
class QueueBench {
 public:
  static constexpr int kLanes = Dut::kLaneCount;
  using Plan = QueuePlan<kLanes>;

  std::vector<int64_t> entered, lit, left;  // cycle of each group
  size_t most_inside = 0;

  // Ends when all groups left; fails when nothing moves for longer than plan and sink allow.
  void Run(const Plan& plan, const FlowPattern& sink, int64_t limit = int64_t{1} << 40) {
    int64_t offer = plan.gap[0];
    int64_t deadline = 0;
    const int64_t patience = 2 * sink.longest_gap() + 1000;
    for (int64_t cycle = 0; left.size() < plan.size() && cycle < limit; ++cycle) {
      const size_t before = entered.size() + left.size();
      const bool offering = entered.size() < plan.size() && cycle >= offer;
      Drive(plan, cycle, offering, sink.At(cycle));
      ASSERT_NO_FATAL_FAILURE(Expect(plan, cycle));
      Observe(cycle, offering, sink.At(cycle));
      if (offering && entered.back() == cycle && entered.size() < plan.size()) {
        offer = cycle + 1 + plan.gap[entered.size()];
      }
      rtl_.Tick();
      rtl_.Settle();
      if (entered.size() + left.size() != before) deadline = cycle + patience;
      ASSERT_LE(cycle, std::max(deadline, patience)) << "nothing moves";
    }
    if (left.size() < plan.size()) return;
    EXPECT_FALSE(rtl_.busy() || rtl_.pixel_valid()) << "not empty after the last group";
  }
  Dut& rtl() { return rtl_; }

 private:
  size_t inside() const { return entered.size() - left.size(); }
  bool full() const { return inside() == static_cast<size_t>(PixelQueue::kDepth); }

  // Every payload that is not valid is noise.
  void Drive(const Plan& plan, int64_t cycle, bool offering, bool ready) {
    const auto noise = RandomGroup<kLanes>(random_);
    rtl_.Enter(offering, offering ? plan.groups[entered.size()] : noise);
    const bool enters = offering && !full();
    cosines_ =
        cosined_ < entered.size() + enters &&
        cycle >= (cosined_ < entered.size() ? entered[cosined_] : cycle) + plan.cosines[cosined_];
    rtl_.Cosines(cosines_);
    const size_t next = lit.size();
    light_ = next < entered.size() && cycle >= entered[next] + plan.light[next];
    rtl_.Light(light_, light_ ? plan.groups[next] : noise);
    rtl_.Ready(ready);
    rtl_.Settle();
  }

  void Expect(const Plan& plan, int64_t cycle) const {
    ASSERT_EQ(rtl_.enter_ready(), !full()) << "cycle " << cycle << ", " << inside() << " inside";
    ASSERT_EQ(rtl_.busy(), inside() > 0) << "cycle " << cycle;
    ASSERT_EQ(rtl_.pixel_valid(), lit.size() > left.size()) << "cycle " << cycle;
    if (cosines_) {
      ASSERT_EQ(rtl_.material(), plan.groups[cosined_].material) << "group " << cosined_;
    }
    if (!rtl_.pixel_valid()) return;
    const tb::PixelGroup<kLanes>& group = plan.groups[left.size()];
    ASSERT_EQ(rtl_.mask(), group.mask) << "group " << left.size();
    ASSERT_EQ(rtl_.unlit(), group.unlit & group.mask) << "group " << left.size();
    ASSERT_EQ(rtl_.no_highlight(), group.no_highlight & group.mask) << "group " << left.size();
    for (size_t lane = 0; lane < kLanes; ++lane) {
      if (!(group.mask >> lane & 1)) continue;
      ASSERT_TRUE(rtl_.pixel(lane) == group.pixel[lane])
          << "group " << left.size() << " lane " << lane << " in cycle " << cycle;
    }
  }

  void Observe(int64_t cycle, bool offering, bool ready) {
    const bool leaves = rtl_.pixel_valid() && ready;
    if (offering && rtl_.enter_ready()) entered.push_back(cycle);
    if (cosines_) ++cosined_;
    if (light_) lit.push_back(cycle);
    most_inside = std::max(most_inside, inside());
    if (leaves) left.push_back(cycle);
  }

  Dut rtl_;
  std::mt19937 random_{7};
  size_t cosined_ = 0;  // groups whose cosines came
  bool cosines_ = false, light_ = false;
};

}  // namespace shading
