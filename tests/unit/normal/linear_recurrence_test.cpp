// SPDX-License-Identifier: Apache-2.0
#include "model/normal/linear_recurrence.h"

#include <gtest/gtest.h>

#include "tb/dut/linear_recurrence_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/quantity_stimulus.h"

namespace shading {
namespace {

constexpr int kBoundedLength = 2048;  // pixels for which the contract states its error

struct Bench {
  using Model = LinearRecurrence;
  using Dut = tb::LinearRecurrenceDut;
  static constexpr int kLanes = 1;

  static Model Make(const QuantityStart& start) { return Model(start.seed[0]); }
  static void Cycle(Dut& rtl, bool load, bool step, const QuantityStart& start) {
    rtl.Cycle(load, step, start.seed[0]);
  }
  template <typename Source>
  static Quantity Value(const Source& source, int) {
    return source.value();
  }
};

class LinearRecurrenceFlow : public testing::TestWithParam<Flow> {};

TEST_P(LinearRecurrenceFlow, RtlMatchesModel) {
  ExpectSameValues<Bench>(PatternOf(GetParam(), 1), 4000, 2);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, LinearRecurrenceFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(LinearRecurrence, ContractMatchesRtl) { ExpectTiming<Bench>(LinearRecurrence::kContract); }

TEST(LinearRecurrence, LoadWinsOverStepAndIdleHolds) { ExpectLoadWinsAndIdleHolds<Bench>(); }

Real Ulps(Quantity value, Real ideal) {
  return std::abs(static_cast<Real>(value.raw()) - std::ldexp(ideal, Quantity::kFraction));
}

Real Bound(int t) { return (t + 1) / 2.0L; }

// A straight line between two values at the ends of a span.
TEST(LinearRecurrence, ModelWithinErrorBound) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> unit(-1, 1);
  Real worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Real first = unit(random), last = unit(random);
    const Real difference = (last - first) / (kBoundedLength - 1);
    LinearRecurrence model({RoundQuantity(first), RoundQuantity(difference)});
    for (int t = 0; t < kBoundedLength; ++t, model.Step()) {
      const Real error = Ulps(model.value(), first + difference * t);
      ASSERT_LE(error, Bound(t) + 1e-3L) << "line " << i << " pixel " << t;
      worst = std::max(worst, error);
    }
  }
  RecordProperty("worst_ulp", static_cast<int>(worst));
  EXPECT_LE(Bound(kBoundedLength - 1), LinearRecurrence::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.99L * Bound(kBoundedLength - 1)) << "the search is blind";
}

TEST(LinearRecurrence, LeavesTheRangeAndComesBack) {
  // 1.5, 2.25, ...: the second value wraps to -1.75, the registers keep the sum modulo 4.
  LinearRecurrence model({Quantity::Round(1.5), Quantity::Round(0.75)});
  for (const double value : {1.5, -1.75, -1.0, -0.25, 0.5}) {
    EXPECT_EQ(model.value().ToReal(), value);
    model.Step();
  }
}

}  // namespace
}  // namespace shading
