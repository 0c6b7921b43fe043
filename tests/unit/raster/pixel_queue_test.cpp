// SPDX-License-Identifier: Apache-2.0
#include "model/raster/pixel_queue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "tb/dut/pixel_queue_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/raster/pixel_queue_stimulus.h"

namespace shading {
namespace {

constexpr size_t kDepth = PixelQueue::kDepth;
// From entry to codes; one cycle later the group is on offer.
constexpr int kLongestLight = static_cast<int>(kDepth) - 1 - PixelQueue::kContract.latency_cycles;
using Dut = tb::PixelQueueDut;
using Dut4 = tb::PixelQueue4Dut;
using ShadedDut = tb::PixelQueueShadedDut;
using Shaded4Dut = tb::PixelQueueShaded4Dut;

// Groups that come in the cycles of a flow, through a light whose length changes from group to
// group, 1 to 63 cycles, and whose cosines are early, late or in the cycle of the entry. Those that
// enter with their codes come one by one or many in a row.
template <int kLanes>
QueuePlan<kLanes> RandomPlan(Flow source, size_t groups, std::mt19937& random) {
  QueuePlan<kLanes> plan = SteadyPlan<kLanes>(groups, 0, 1, 1);
  int longest = 1;
  bool shaded = false;
  for (size_t g = 0; g < groups; ++g) {
    if (random() % 16 == 0) shaded = random() % 2;
    if (random() % 8 != 0) plan.groups[g].shaded = shaded;
    if (random() % 64 == 0) longest = 1 + static_cast<int>(random() % 63);
    const int light = random() % 2 ? longest : 1 + static_cast<int>(random() % longest);
    plan.light[g] = light;
    plan.cosines[g] = random() % 2 ? 0 : static_cast<int>(random() % light);
    plan.gap[g] = source == Flow::kAlways      ? 0
                  : source == Flow::kOneInFour ? 3
                                               : static_cast<int>(random() % 4);
  }
  return plan;
}

using Flows = std::tuple<Flow, Flow>;
class PixelQueueFlow : public testing::TestWithParam<Flows> {
 protected:
  // Every output of every cycle, every group once and in order.
  template <typename Build>
  void ExpectOutputs() {
    const auto [source, sink] = GetParam();
    std::mt19937 random(1);
    const auto plan = RandomPlan<Build::kLaneCount>(source, 40000, random);
    QueueBench<Build> bench;
    ASSERT_NO_FATAL_FAILURE(bench.Run(plan, PatternOf(sink, 2)));
    EXPECT_EQ(bench.left.size(), plan.size());
    EXPECT_LE(bench.most_inside, kDepth);
    if (source == Flow::kAlways) {
      EXPECT_EQ(bench.most_inside, kDepth) << "never full";
    }
  }
};

TEST_P(PixelQueueFlow, RtlMatchesModel) { ExpectOutputs<Dut>(); }
TEST_P(PixelQueueFlow, FourLanesMatchModel) { ExpectOutputs<Dut4>(); }
TEST_P(PixelQueueFlow, ShadedMatchesModel) { ExpectOutputs<ShadedDut>(); }
TEST_P(PixelQueueFlow, FourLanesShadedMatchModel) { ExpectOutputs<Shaded4Dut>(); }

constexpr auto kFlows = {Flow::kAlways, Flow::kOneInFour, Flow::kRandom};
INSTANTIATE_TEST_SUITE_P(AllFlows, PixelQueueFlow,
                         testing::Combine(testing::ValuesIn(kFlows), testing::ValuesIn(kFlows)),
                         [](const auto& flow) {
                           return "Source" + NameOf(std::get<0>(flow.param)) + "Sink" +
                                  NameOf(std::get<1>(flow.param));
                         });

template <typename Build>
void ExpectTiming() {
  EXPECT_EQ(Build::kLatency, PixelQueue::kContract.latency_cycles);
  QueueBench<Build> bench;
  bench.Run(SteadyPlan<Build::kLaneCount>(100, 3, 7, 1), FlowPattern::Always());
  ASSERT_EQ(bench.left.size(), 100u);
  for (size_t g = 0; g < 100; ++g) {
    EXPECT_EQ(bench.left[g] - bench.lit[g], PixelQueue::kContract.latency_cycles);
    if (g > 0) {
      EXPECT_EQ(bench.left[g] - bench.left[g - 1], PixelQueue::kContract.interval_cycles);
    }
  }
}

TEST(PixelQueue, ContractMatchesRtl) {
  ExpectTiming<Dut>();
  ExpectTiming<Dut4>();
}

template <int kLanes>
void SetShaded(bool shaded, QueuePlan<kLanes>* plan) {
  for (auto& group : plan->groups) group.shaded = shaded;
}

// Groups with their codes leave a cycle after they entered, at the same rate.
template <typename Build>
void ExpectTimingOfShaded() {
  auto plan = SteadyPlan<Build::kLaneCount>(100, 3, 7, 1);
  SetShaded(true, &plan);
  QueueBench<Build> bench;
  bench.Run(plan, FlowPattern::Always());
  EXPECT_TRUE(bench.lit.empty());
  ASSERT_EQ(bench.left.size(), 100u);
  for (size_t g = 0; g < 100; ++g) {
    EXPECT_EQ(bench.entered[g], static_cast<int64_t>(g));
    EXPECT_EQ(bench.left[g] - bench.entered[g], PixelQueue::kContract.latency_cycles);
  }
}

TEST(PixelQueue, GroupsWithCodesLeaveInTheNextCycle) {
  ExpectTimingOfShaded<ShadedDut>();
  ExpectTimingOfShaded<Shaded4Dut>();
}

// One group is lit for 40 cycles; those behind it have their codes, and wait.
template <typename Build>
void ExpectOrder() {
  auto plan = SteadyPlan<Build::kLaneCount>(30, 3, 40, 1);
  SetShaded(true, &plan);
  plan.groups[0].shaded = false;
  QueueBench<Build> bench;
  bench.Run(plan, FlowPattern::Always());
  ASSERT_EQ(bench.left.size(), 30u);
  EXPECT_EQ(bench.left[0], 40 + PixelQueue::kContract.latency_cycles);
  EXPECT_EQ(bench.left[29], bench.left[0] + 29);
}

TEST(PixelQueue, GroupsWithCodesWaitForThoseThatAreLit) {
  ExpectOrder<ShadedDut>();
  ExpectOrder<Shaded4Dut>();
}

// Spans of 1 to `longest` groups; the groups of a span come without a gap, and all or none of them
// with codes.
QueuePlan<1> SpanPlan(int spans, uint32_t longest, int light, std::mt19937& random,
                      std::vector<int64_t>* lengths) {
  lengths->clear();
  std::vector<int> gap;
  std::vector<bool> shaded;
  for (int span = 0; span < spans; ++span) {
    const int64_t length = random() % 3 == 0 ? 1 : 1 + static_cast<int64_t>(random() % longest);
    lengths->push_back(length);
    gap.push_back(random() % 2 ? 0 : static_cast<int>(random() % 70));
    gap.resize(gap.size() + static_cast<size_t>(length) - 1, 0);
    shaded.resize(gap.size(), random() % 2);
  }
  QueuePlan<1> plan = SteadyPlan<1>(gap.size(), light - 1, light, 1);
  plan.gap = gap;
  for (size_t g = 0; g < gap.size(); ++g) plan.groups[g].shaded = shaded[g];
  return plan;
}

// Entry and leave of every group from the cycle model, span by span.
template <typename Build>
void ExpectModelCycles(const QueuePlan<1>& plan, const std::vector<int64_t>& lengths, int light,
                       const FlowPattern& sink) {
  QueueBench<Build> bench;
  ASSERT_NO_FATAL_FAILURE(bench.Run(plan, sink));
  PixelQueue queue;
  int64_t entered = -1, left = -1;
  for (const int64_t length : lengths) {
    const int64_t first = queue.groups();
    const int64_t offered = entered + 1 + plan.gap[static_cast<size_t>(first)];
    entered = std::max(offered, queue.RoomFor(first, sink) + 1);
    const bool shaded = Build::kHasShaded && plan.groups[static_cast<size_t>(first)].shaded;
    const int64_t valid =
        std::max(entered + (shaded ? 0 : light) + PixelQueue::kContract.latency_cycles, left + 1);
    const int64_t rank = sink.always() ? valid : sink.Rank(valid);
    queue.Add({first, length, valid, rank});
    for (int64_t i = 0; i < length; ++i) {
      const auto group = static_cast<size_t>(first + i);
      if (i > 0) entered = std::max(entered + 1, queue.RoomFor(first + i, sink) + 1);
      ASSERT_EQ(bench.entered[group], entered) << "group " << group << ", light " << light;
      left = sink.always() ? valid + i : sink.Select(rank + i);
      ASSERT_EQ(bench.left[group], left) << "group " << group << ", light " << light;
    }
  }
}

TEST(PixelQueue, CyclesMatchModel) {
  std::mt19937 random(1);
  std::vector<int64_t> lengths;
  for (int light = 1; light <= kLongestLight; ++light) {
    for (const Flow flow : kFlows) {
      const uint32_t longest = light % 2 ? 300 : 4;
      const QueuePlan<1> plan = SpanPlan(200, longest, light, random, &lengths);
      const FlowPattern sink = PatternOf(flow, 5);
      ASSERT_NO_FATAL_FAILURE(ExpectModelCycles<Dut>(plan, lengths, light, sink));
      ASSERT_NO_FATAL_FAILURE(ExpectModelCycles<ShadedDut>(plan, lengths, light, sink));
    }
  }
}

// Full rate: 63 cycles from entry to offer are the most that 64 places hide; at 64 every 64th
// group comes one cycle late.
template <typename Build>
int64_t CyclesOf(size_t groups, int light) {
  QueueBench<Build> bench;
  bench.Run(SteadyPlan<Build::kLaneCount>(groups, light - 1, light, 1), FlowPattern::Always());
  return bench.left.size() < groups ? 0 : bench.left.back() - bench.left.front() + 1;
}

TEST(PixelQueue, NoBubbleAtFullRate) {
  for (const int light : {1, 13, kLongestLight}) {
    EXPECT_EQ(CyclesOf<Dut>(1280, light), 1280) << "light " << light;
    EXPECT_EQ(CyclesOf<Dut4>(1280, light), 1280) << "light " << light;
  }
  EXPECT_EQ(CyclesOf<Dut>(1280, kLongestLight + 1), 1280 + 1280 / 64 - 1);
}

template <typename Build>
void ExpectSixtyFourPlaces() {
  QueueBench<Build> bench;
  const auto plan = SteadyPlan<Build::kLaneCount>(200, 0, 1, 1);  // some with codes
  const std::string stall(300, '0');
  bench.Run(plan, FlowPattern::Recorded(stall + "10001"));
  ASSERT_EQ(bench.left.size(), 200u);
  EXPECT_EQ(bench.most_inside, kDepth);
  for (size_t g = 0; g < kDepth; ++g) EXPECT_EQ(bench.entered[g], static_cast<int64_t>(g));
  for (size_t g = kDepth; g < 200; ++g) {
    EXPECT_EQ(bench.entered[g], bench.left[g - kDepth] + 1) << "a place is free one cycle later";
  }
}

TEST(PixelQueue, HoldsSixtyFourGroups) {
  ExpectSixtyFourPlaces<Dut>();
  ExpectSixtyFourPlaces<Dut4>();
  ExpectSixtyFourPlaces<ShadedDut>();
  ExpectSixtyFourPlaces<Shaded4Dut>();
}

template <typename Build>
void ExpectEmptyAfterReset() {
  QueueBench<Build> bench;
  bench.Run(SteadyPlan<Build::kLaneCount>(40, 1, 9, 1), FlowPattern::Always(), 20);
  ASSERT_GT(bench.entered.size(), bench.left.size());
  bench.rtl().Reset();
  EXPECT_TRUE(bench.rtl().enter_ready());
  EXPECT_FALSE(bench.rtl().busy());
  EXPECT_FALSE(bench.rtl().pixel_valid());
}

TEST(PixelQueue, ResetDropsTheGroups) {
  ExpectEmptyAfterReset<Dut4>();
  ExpectEmptyAfterReset<Shaded4Dut>();
}

TEST(PixelQueueDeathTest, CodesOfNoPixelStopTheSimulation) {
  Dut rtl;
  rtl.Light(true, {});
  EXPECT_EXIT(rtl.Tick(), testing::KilledBySignal(SIGABRT), "");
}

TEST(PixelQueueDeathTest, CodesForAGroupThatHasThemStopTheSimulation) {
  ShadedDut rtl;
  tb::PixelGroup<1> group;
  group.shaded = true;
  rtl.Enter(true, group);
  rtl.Tick();
  rtl.Enter(false, group);
  rtl.Light(true, group);
  EXPECT_EXIT(rtl.Tick(), testing::KilledBySignal(SIGABRT), "");
}

TEST(PixelQueueDeathTest, CosinesOfNoPixelStopTheSimulation) {
  Dut rtl;
  rtl.Cosines(true);
  EXPECT_EXIT(rtl.Tick(), testing::KilledBySignal(SIGABRT), "");
}

}  // namespace
}  // namespace shading
