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
// through. A group that enters with its codes passes by.
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
  group.dark = random() & 1;
  group.shaded = random() & 1;
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
// the cycles of what happened. A build without HasShaded lights every group.
template <typename Dut>
class QueueBench {
 public:
  static constexpr int kLanes = Dut::kLaneCount;
  using Plan = QueuePlan<kLanes>;

  std::vector<int64_t> entered, left;  // cycle of each group
  std::vector<int64_t> lit;            // of each group that is lit
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
      Observe(plan, cycle, offering, sink.At(cycle));
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
  static bool IsLit(const Plan& plan, size_t group) {
    return !(Dut::kHasShaded && plan.groups[group].shaded);
  }

  // Every payload that is not valid is noise.
  void Drive(const Plan& plan, int64_t cycle, bool offering, bool ready) {
    const auto noise = RandomGroup<kLanes>(random_);
    rtl_.Enter(offering, offering ? Offered(plan.groups[entered.size()], noise) : noise);
    // The group whose cosines come next may be the one that enters in this cycle.
    const bool waits = cosined_ < to_light_.size();
    const bool enters = offering && !full() && IsLit(plan, entered.size());
    const size_t at = waits ? to_light_[cosined_] : entered.size();
    cosines_ = (waits || enters) && cycle >= (waits ? entered[at] : cycle) + plan.cosines[at];
    rtl_.Cosines(cosines_);
    lighting_ = at;
    const size_t next = lit.size();
    light_ =
        next < to_light_.size() && cycle >= entered[to_light_[next]] + plan.light[to_light_[next]];
    rtl_.Light(light_, light_ ? plan.groups[to_light_[next]] : noise);
    rtl_.Ready(ready);
    rtl_.Settle();
  }
  // A group that is to be lit has no codes yet.
  static tb::PixelGroup<kLanes> Offered(tb::PixelGroup<kLanes> group,
                                        const tb::PixelGroup<kLanes>& noise) {
    if (Dut::kHasShaded && group.shaded) return group;
    for (size_t lane = 0; lane < kLanes; ++lane) {
      group.pixel[lane].r = noise.pixel[lane].r;
      group.pixel[lane].g = noise.pixel[lane].g;
      group.pixel[lane].b = noise.pixel[lane].b;
    }
    return group;
  }

  void Expect(const Plan& plan, int64_t cycle) const {
    ASSERT_EQ(rtl_.enter_ready(), !full()) << "cycle " << cycle << ", " << inside() << " inside";
    ASSERT_EQ(rtl_.busy(), inside() > 0) << "cycle " << cycle;
    ASSERT_EQ(rtl_.pixel_valid(), inside() > 0 && has_codes_[left.size()]) << "cycle " << cycle;
    if (cosines_) {
      ASSERT_EQ(rtl_.material(), plan.groups[lighting_].material) << "group " << lighting_;
      ASSERT_EQ(rtl_.dark(), plan.groups[lighting_].dark) << "group " << lighting_;
    }
    if (!rtl_.pixel_valid()) return;
    const tb::PixelGroup<kLanes>& group = plan.groups[left.size()];
    const uint32_t flagged = IsLit(plan, left.size()) ? group.mask : 0;
    ASSERT_EQ(rtl_.mask(), group.mask) << "group " << left.size();
    ASSERT_EQ(rtl_.unlit(), group.unlit & flagged) << "group " << left.size();
    ASSERT_EQ(rtl_.no_highlight(), group.no_highlight & flagged) << "group " << left.size();
    for (size_t lane = 0; lane < kLanes; ++lane) {
      if (!(group.mask >> lane & 1)) continue;
      ASSERT_TRUE(rtl_.pixel(lane) == group.pixel[lane])
          << "group " << left.size() << " lane " << lane << " in cycle " << cycle;
    }
  }

  void Observe(const Plan& plan, int64_t cycle, bool offering, bool ready) {
    const bool leaves = rtl_.pixel_valid() && ready;
    if (light_) {
      has_codes_[to_light_[lit.size()]] = true;
      lit.push_back(cycle);
    }
    if (offering && rtl_.enter_ready()) {
      const bool is_lit = IsLit(plan, entered.size());
      if (is_lit) to_light_.push_back(entered.size());
      has_codes_.push_back(!is_lit);
      entered.push_back(cycle);
    }
    if (cosines_) ++cosined_;
    most_inside = std::max(most_inside, inside());
    if (leaves) left.push_back(cycle);
  }

  Dut rtl_;
  std::mt19937 random_{7};
  std::vector<bool> has_codes_;   // of each group that entered
  std::vector<size_t> to_light_;  // groups that entered and are lit
  size_t cosined_ = 0;            // of these, whose cosines came
  size_t lighting_ = 0;           // the group whose cosines come in this cycle
  bool cosines_ = false, light_ = false;
};

}  // namespace shading
