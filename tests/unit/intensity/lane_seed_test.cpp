// SPDX-License-Identifier: Apache-2.0
#include "model/intensity/lane_seed.h"

#include <gtest/gtest.h>

#include <random>

#include "model/intensity/flat_color.h"
#include "model/intensity/gouraud_interpolator.h"
#include "model/intensity/quad_surface.h"
#include "tb/dut/lane_seed_dut.h"
#include "tests/unit/intensity/seed_stimulus.h"

namespace shading {
namespace {

constexpr int kLanes = 4;

// A number modulo 2^36, as S9.26.
int64_t Residue(Int128 value) {
  const Int128 turn = Int128{1} << IntensityAcc::kWidth;
  const Int128 rest = value - turn * FloorDivide<Int128>(value, turn);
  return static_cast<int64_t>(rest >= turn / 2 ? rest - turn : rest);
}

// I(t) of the parabola through the seed, expanded in wide integers: no register that could wrap.
//   2 I(t) = 2 I(0) + (2 D - 2A) t + 2A t^2
Int128 Intensity(const ChannelSeed& seed, int t) {
  const Int128 wide_t = t;
  const Int128 curvature = seed.curvature.raw();
  return (2 * static_cast<Int128>(seed.first.raw()) +
          (2 * static_cast<Int128>(seed.difference.raw()) - curvature) * wide_t +
          curvature * wide_t * wide_t) /
         2;
}

// Four unrelated numbers, or a curve whose second value is what it must be.
ChannelSeed RandomCurve(std::mt19937& random) { return RandomSeed(RandomLength(random), random); }

void ExpectSeed(const ChannelSeed& actual, const ChannelSeed& expected) {
  ASSERT_EQ(actual.first.raw(), expected.first.raw());
  ASSERT_EQ(actual.second.raw(), expected.second.raw());
  ASSERT_EQ(actual.difference.raw(), expected.difference.raw());
  ASSERT_EQ(actual.curvature.raw(), expected.curvature.raw());
}

// What the build for this lane is called with: Lane and Lanes.
template <typename Build, int kAtLane, int kOf>
struct Lane {
  using Dut = Build;
  static constexpr int kLane = kAtLane, kLaneCount = kOf;
};

template <typename Setting>
class LaneSeedBuild : public testing::Test {};
using Builds =
    testing::Types<Lane<tb::LaneSeedDut, 0, 1>, Lane<tb::LaneSeed0Of4Dut, 0, kLanes>,
                   Lane<tb::LaneSeed1Of4Dut, 1, kLanes>, Lane<tb::LaneSeed2Of4Dut, 2, kLanes>,
                   Lane<tb::LaneSeed3Of4Dut, 3, kLanes>>;
TYPED_TEST_SUITE(LaneSeedBuild, Builds, );

TYPED_TEST(LaneSeedBuild, RtlMatchesModel) {
  std::mt19937 random(1);
  typename TypeParam::Dut rtl;
  for (int i = 0; i < 300000; ++i) {
    const ChannelSeed seed = RandomCurve(random);
    ASSERT_NO_FATAL_FAILURE(
        ExpectSeed(rtl.Of(seed), LaneSeed::Of(seed, TypeParam::kLane, TypeParam::kLaneCount)))
        << "seed " << i;
  }
}

// Without a clock the output belongs to the input of the same cycle.
TYPED_TEST(LaneSeedBuild, ContractMatchesRtl) {
  EXPECT_EQ(TypeParam::Dut::kLatency, LaneSeed::kContract.latency_cycles);
  EXPECT_EQ(LaneSeed::kContract.interval_cycles, 1);
  typename TypeParam::Dut rtl;
  for (int64_t code = 0; code < 16; ++code) {
    EXPECT_EQ(rtl.Of(SeedOf(code * kOneCode, 0, 0, 0)).first.raw(), code * kOneCode);
  }
}

// RTL of one lane and closed form: first value, the value one stride on, and both differences of
// the values that the lane shows. Modulo 2^36, so the numbers may have any size.
TYPED_TEST(LaneSeedBuild, ModelWithinErrorBound) {
  constexpr int kLane = TypeParam::kLane, kStride = TypeParam::kLaneCount;
  std::mt19937 random(2);
  typename TypeParam::Dut rtl;
  for (int i = 0; i < 200000; ++i) {
    ChannelSeed seed = RandomCurve(random);
    seed.second = IntensityAcc::Wrap(seed.first.raw() + seed.difference.raw());
    const ChannelSeed lane = rtl.Of(seed);
    const Int128 here = Intensity(seed, kLane), next = Intensity(seed, kLane + kStride);
    const Int128 after = Intensity(seed, kLane + 2 * kStride);
    ASSERT_EQ(lane.first.raw(), Residue(here));
    ASSERT_EQ(lane.second.raw(), Residue(next));
    ASSERT_EQ(lane.difference.raw(), Residue(next - here));
    ASSERT_EQ(lane.curvature.raw(), Residue(after - 2 * next + here));
  }
  EXPECT_EQ(LaneSeed::kContract.max_error_ulp, 0);
}

// A march of four lanes shows the codes that a march of one lane shows, also where they clamp.
template <typename Unit>
void ExpectSameMarch(bool curved) {
  std::mt19937 random(3);
  for (int span = 0; span < 2000; ++span) {
    const int length = RandomLength(random);
    ChannelSeed seed = RandomCurve(random);
    if (!curved) seed.curvature = {};
    seed.second = IntensityAcc::Wrap(seed.first.raw() + seed.difference.raw());
    for (int lane = 0; lane < kLanes && lane < length; ++lane) {
      Unit one(seed), many(LaneSeed::Of(seed, lane, kLanes));
      for (int t = 0; t < lane; ++t) one.Step();
      for (int t = lane; t < length; t += kLanes, many.Step()) {
        ASSERT_EQ(many.code(), one.code()) << "span " << span << " pixel " << t;
        for (int k = 0; k < kLanes; ++k) one.Step();
      }
    }
  }
}

TEST(LaneSeed, FourLanesShowWhatOneShows) {
  ExpectSameMarch<GouraudInterpolator>(false);
  ExpectSameMarch<QuadSurface>(true);
}

TEST(LaneSeed, OneLaneIsTheSeedItself) {
  const ChannelSeed odd = SeedOf(kMostAcc, kLeastAcc, -1, kMostAcc);
  ExpectSeed(LaneSeed::Of(odd, 0, 1), odd);
  tb::LaneSeedDut rtl;
  ExpectSeed(rtl.Of(odd), odd);
}

TEST(LaneSeed, ExtremesWrap) {
  for (const int64_t value : {kMostAcc, kLeastAcc, int64_t{-1}, int64_t{1}}) {
    const ChannelSeed seed = SeedOf(value, value, value, value);
    tb::LaneSeed3Of4Dut rtl;
    const ChannelSeed lane = rtl.Of(seed);
    EXPECT_EQ(lane.first.raw(), Residue(static_cast<Int128>(value) * 7));    // 1 + 3 + 3
    EXPECT_EQ(lane.second.raw(), Residue(static_cast<Int128>(value) * 29));  // 1 + 7 + 21
    EXPECT_EQ(lane.difference.raw(), Residue(static_cast<Int128>(value) * 22));  // 4 + 18
    EXPECT_EQ(lane.curvature.raw(), Residue(static_cast<Int128>(value) * 16));
  }
}

}  // namespace
}  // namespace shading
