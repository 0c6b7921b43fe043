// SPDX-License-Identifier: Apache-2.0
#include "model/normal/normal_setup.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "model/normal/normal_setup_table.h"
#include "tb/dut/normal_setup_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/normal_setup_accuracy.h"

namespace shading {
namespace {

constexpr Real kPi = 2 * kQuarterTurn;

int RandomLength(std::mt19937& random) {
  constexpr int kCorners[] = {1, 2, 3, 4, 5, 8, 9, 2048, 2049, 4095, 4096};
  if (random() % 4 == 0) return kCorners[random() % 11];
  return 1 + static_cast<int>(random() % (2u << random() % 12));
}
Real RandomAngle(std::mt19937& random) {
  if (random() % 4 == 0) return random() % 2 ? 0 : kPi / 2;
  return kPi / 2 * std::pow(2.0L, -static_cast<Real>(random() % 22000) / 1000);
}
SpanCommand RandomSpan(std::mt19937& random) {
  SpanCommand span = SpanOf(RandomPlane(random), RandomAngle(random), RandomLength(random));
  span.x = static_cast<int>(random() % 4096);
  span.y = static_cast<int>(random() % 4096);
  span.z = DepthAcc::Wrap(static_cast<int64_t>(random()) << 8);
  if (random() % 8 == 0) span.normal[1] = span.normal[0];
  return span;
}
LightState RandomLight(std::mt19937& random) {
  LightState light;
  const RealVector l = RandomPlane(random).start, h = RandomPlane(random).start;
  for (size_t i = 0; i < 3; ++i) {
    light.light[i] = NormalComponent::Round(static_cast<double>(l[i]));
    light.half_or_view[i] = NormalComponent::Round(static_cast<double>(h[i]));
  }
  return light;
}

constexpr std::array<SetupKind, 6> kKinds = {{{false, false, false},
                                              {false, true, true},
                                              {false, false, true},
                                              {false, true, false},
                                              {true, false, false},
                                              {true, true, false}}};

void ExpectKappa(const Kappa& rtl, const Kappa& model) {
  ASSERT_EQ(rtl.mantissa.raw(), model.mantissa.raw());
  ASSERT_EQ(rtl.exponent, model.exponent);
}
void ExpectSeed(const NormalSeed& rtl, const NormalSeed& model) {
  for (size_t i = 0; i < 3; ++i) {
    for (size_t lane = 0; lane < kMaxLanes; ++lane) {
      ASSERT_EQ(rtl.quantity[i][lane].first.raw(), model.quantity[i][lane].first.raw());
      ASSERT_EQ(rtl.quantity[i][lane].difference.raw(), model.quantity[i][lane].difference.raw());
    }
  }
  for (size_t lane = 0; lane < kMaxLanes; ++lane) {
    ASSERT_EQ(rtl.length_square[lane].first, model.length_square[lane].first);
    ASSERT_EQ(rtl.length_square[lane].difference, model.length_square[lane].difference);
    ASSERT_EQ(rtl.length_square[lane].curvature, model.length_square[lane].curvature);
  }
  ExpectKappa(rtl.kappa, model.kappa);
  for (size_t i = 0; i < 2; ++i) ExpectKappa(rtl.step_kappa[i], model.step_kappa[i]);
}

// The timing rule of the model's header.
template <typename Result>
void ExpectCycles(const Result& result, int lanes, const FlowPattern& span,
                  const FlowPattern& seed) {
  const auto stages = static_cast<size_t>(NormalSetup::StageCount(lanes));
  std::vector<int64_t> before(stages + 2, 0), now(stages + 2);
  int64_t next = 0;
  for (size_t k = 0; k < result.spans.size(); ++k, before = now) {
    now[0] = std::max(span.Next(next), before[1]);
    for (size_t j = 0; j < stages; ++j) {
      now[j + 1] = std::max(now[j] + NormalSetup::kSteps, before[j + 2]);
    }
    now[stages + 1] = seed.Next(now[stages] + 1);
    ASSERT_EQ(result.spans[k], now[0]) << "span " << k;
    ASSERT_EQ(result.seeds[k].offered, now[stages] + 1) << "span " << k;
    ASSERT_EQ(result.seeds[k].taken, now[stages + 1]) << "span " << k;
    next = now[0] + 1;
  }
}

template <typename Dut>
void ExpectRun(int count, Flow span_flow, Flow seed_flow, uint32_t start) {
  std::mt19937 random(start);
  Dut rtl;
  // Each kind alone, then all of them in turns: a span keeps its own.
  std::vector<std::vector<SetupKind>> runs;
  for (const SetupKind& kind : kKinds) runs.push_back({kind});
  runs.emplace_back(std::begin(kKinds), std::end(kKinds));
  for (const std::vector<SetupKind>& kinds : runs) {
    const LightState light = RandomLight(random);
    std::vector<SpanCommand> spans;
    for (int i = 0; i < count; ++i) spans.push_back(RandomSpan(random));
    const FlowPattern span = PatternOf(span_flow, start), seed = PatternOf(seed_flow, start + 1);
    const auto result = rtl.Run(kinds, light, spans, span, seed);
    ASSERT_EQ(result.failure, "");
    ExpectCycles(result, Dut::kLaneCount, span, seed);
    for (size_t i = 0; i < spans.size(); ++i) {
      NormalSeed model;
      NormalSetup::Seed(kinds[i % kinds.size()], light, spans[i], Dut::kLaneCount, &model);
      ExpectSeed(result.seeds[i].seed, model);
      ASSERT_EQ(result.seeds[i].run.x, spans[i].x);
      ASSERT_EQ(result.seeds[i].run.length, spans[i].length);
      ASSERT_EQ(result.seeds[i].run.z, spans[i].z);
      ASSERT_FALSE(testing::Test::HasFatalFailure())
          << "span " << i << " of " << spans[i].length << " pixels";
    }
  }
}

TEST(NormalSetup, RtlMatchesModel) {
  for (const Flow span : {Flow::kAlways, Flow::kOneInFour, Flow::kRandom}) {
    for (const Flow seed : {Flow::kAlways, Flow::kOneInFour, Flow::kRandom}) {
      ExpectRun<tb::NormalSetupDut>(1000, span, seed, 1);
      ASSERT_FALSE(HasFatalFailure()) << "spans " << NameOf(span) << " seeds " << NameOf(seed);
      ExpectRun<tb::NormalSetup4Dut>(1000, span, seed, 2);
      ASSERT_FALSE(HasFatalFailure()) << "spans " << NameOf(span) << " seeds " << NameOf(seed);
    }
  }
}

TEST(NormalSetup, ContractMatchesRtl) {
  EXPECT_EQ(tb::NormalSetupDut::kLatency, NormalSetup::kContract.latency_cycles);
  EXPECT_EQ(tb::NormalSetupDut::kLatency, NormalSetup::Latency(1));
  EXPECT_EQ(tb::NormalSetup4Dut::kLatency, NormalSetup::Latency(4));
  EXPECT_EQ(tb::NormalSetupDut::kInterval, NormalSetup::kContract.interval_cycles);
  EXPECT_EQ(tb::NormalSetup4Dut::kInterval, NormalSetup::kSteps);
}

TEST(NormalSetup, ModelWithinErrorBound) {
  for (const int lanes : {1, 4}) {
    const SetupPoint worst = WorstSetup(lanes);
    RecordProperty(lanes == 1 ? "worst_ulp" : "worst_ulp_4", std::to_string(worst.error));
    RecordProperty(lanes == 1 ? "steps" : "steps_4", worst.steps);
    RecordProperty(lanes == 1 ? "degrees" : "degrees_4",
                   std::to_string(90 * worst.turn / kQuarterTurn));
    EXPECT_LE(worst.error, NormalSetup::kContract.max_error_ulp) << lanes << " lanes";
    const double part = lanes == 1 ? 0.55 : 0.7;
    EXPECT_GT(worst.error, part * NormalSetup::kContract.max_error_ulp) << "the search is blind";
  }
}

TEST(NormalSetup, EqualNormalsStandStill) {
  std::mt19937 random(1);
  for (int m = 0; m < 4096; ++m) {
    SpanCommand span = SpanOf(RandomPlane(random), 0.5L, m + 1);
    span.normal[1] = span.normal[0];
    for (const int lanes : {1, 4}) {
      NormalSeed seed;
      NormalSetup::Seed({true, false, false}, {}, span, lanes, &seed);
      ASSERT_EQ(seed.kappa.mantissa.raw(), 0);
      for (size_t i = 0; i < 3; ++i) ASSERT_EQ(seed.quantity[i][0].difference.raw(), 0);
    }
  }
}

template <size_t kSegments>
void ExpectTable(const normal_setup::Table<kSegments>& table, Real width, Real (*f)(Real)) {
  const Real c = std::sqrt(3.0L) / 2, t1 = c / (1 + c), t2 = 2 * c / (1 + c);
  const auto close = [](int64_t raw, Real real) {
    return std::abs(static_cast<Real>(raw) - std::ldexp(real, normal_setup::kTableFraction)) <
           0.52L;
  };
  for (size_t i = 0; i < kSegments; ++i) {
    const Real start = static_cast<Real>(i) * width, f0 = f(start);
    const Real d1 = (f(start + t1 * width) - f0) / t1, d2 = (f(start + t2 * width) - f0) / t2;
    const Real curvature = (d2 - d1) / (t2 - t1);
    ASSERT_TRUE(close(table[i].value, f0)) << i;
    ASSERT_TRUE(close(table[i].slope, d1 - curvature * t1)) << i;
    ASSERT_TRUE(close(table[i].curvature, curvature)) << i;
  }
}

TEST(NormalSetup, TablesFollowTheirFunctions) {
  const auto angle = [](Real x) { return 2 * std::asin(std::sqrt(x / 2)); };
  static const auto kAngle = angle;
  ExpectTable(normal_setup::kReciprocal, 1.0L / 128, [](Real x) { return 1 / (1 + x); });
  ExpectTable(normal_setup::kAngleSquare, 1.0L / 128,
              [](Real x) { return x == 0 ? 1 : kAngle(x) * kAngle(x) / (2 * x); });
  ExpectTable(normal_setup::kAngleOverSine, 1.0L / 128,
              [](Real x) { return x == 0 ? 1 : kAngle(x) / std::sin(kAngle(x)); });
  ExpectTable(normal_setup::kChord, 1.0L / 16, [](Real x) {
    return x == 0 ? 1 : 4 * std::pow(std::sin(std::sqrt(x) / 2), 2.0L) / x;
  });
  ExpectTable(normal_setup::kSineOverAngle, 1.0L / 16,
              [](Real x) { return x == 0 ? 1 : std::sin(std::sqrt(x)) / std::sqrt(x); });
}

}  // namespace
}  // namespace shading
