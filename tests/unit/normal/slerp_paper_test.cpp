// SPDX-License-Identifier: Apache-2.0
#include "model/normal/slerp_paper.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "tb/dut/slerp_paper_dut.h"
#include "tests/unit/flows.h"
#include "tests/unit/normal/quantity_stimulus.h"
#include "tests/unit/normal/slerp_paper_page.h"

namespace shading {
namespace {

template <typename Pins>
struct Bench {
  using Model = SlerpPaper;
  using Dut = Pins;
  static constexpr int kLanes = Dut::kLanes;

  static Model Make(const QuantityStart& start) {
    return Model(start.seed, start.step_kappa, kLanes, Dut::kFractionBits);
  }
  static void Cycle(Dut& rtl, bool load, bool step, const QuantityStart& start) {
    rtl.Cycle(load, step, start.seed, start.step_kappa);
  }
  template <typename Source>
  static Quantity Value(const Source& source, int lane) {
    return source.value(lane);
  }
};
using OneLane = Bench<tb::SlerpPaperDut>;
using OneLaneF16 = Bench<tb::SlerpPaperF16Dut>;
using FourLanes = Bench<tb::SlerpPaperLanes4Dut>;

class SlerpPaperFlow : public testing::TestWithParam<Flow> {};

TEST_P(SlerpPaperFlow, RtlMatchesModel) {
  ExpectSameValues<OneLane>(PatternOf(GetParam(), 1), 3000, 2);
  ExpectSameValues<OneLaneF16>(PatternOf(GetParam(), 1), 3000, 3);
  ExpectSameValues<FourLanes>(PatternOf(GetParam(), 1), 3000, 4);
}

INSTANTIATE_TEST_SUITE_P(AllFlows, SlerpPaperFlow,
                         testing::Values(Flow::kAlways, Flow::kOneInFour, Flow::kRandom),
                         [](const auto& flow) { return NameOf(flow.param); });

TEST(SlerpPaper, ContractMatchesRtl) {
  ExpectTiming<OneLane>(SlerpPaper::kContract);
  ExpectTiming<OneLaneF16>(SlerpPaper::kContract);
  ExpectTiming<FourLanes>(SlerpPaper::kContract);
}

TEST(SlerpPaper, LoadWinsOverStepAndIdleHolds) {
  ExpectLoadWinsAndIdleHolds<OneLane>();
  ExpectLoadWinsAndIdleHolds<OneLaneF16>();
  ExpectLoadWinsAndIdleHolds<FourLanes>();
}

// The bounds of the page at pixel t, in units of 2^-F, to first order in the error.
Real FirstOrderBound(int lanes, int fraction_bits, Real phi, int t) {
  // A coefficient errs by half an ulp and by the rounding of kappa itself; N(0) and N(1) by half an
  // ulp and by the rounding of first and difference.
  const Real kappa = std::ldexp(1.0L, fraction_bits - 29 - 2 * KappaOf(phi).exponent);
  const Real seed = std::ldexp(1.0L, fraction_bits - Quantity::kFraction - 1);
  const Real seeds = fraction_bits == Quantity::kFraction ? t / 2.0L : (3 * t - 1) * seed;
  const Real square = static_cast<Real>(t) * t;
  if (lanes == 1) return (square + t - 1) / 2 + seeds + (square - t) / 2 * kappa;
  return (0.75L * square + 3 * t + 5) * (1 + 8 * kappa) * (1 + phi);
}

// The coefficients' errors act on the erring values: e <= bound (1 + e).
Real Bound(int lanes, int fraction_bits, Real phi, int t) {
  if (t == 0) return 0.5L + std::ldexp(1.0L, fraction_bits - Quantity::kFraction - 1);
  const Real bound = FirstOrderBound(lanes, fraction_bits, phi, t);
  const Real part = std::ldexp(bound, -fraction_bits);
  return part < 1 ? bound / (1 - part) : std::ldexp(4.0L, fraction_bits);
}

// Worst error along an arc in units of 2^-F.
Real WorstError(const Arc& arc, int length, int lanes, int fraction_bits, bool check) {
  const QuantityStart start = arc.Start();
  SlerpPaper model(start.seed, start.step_kappa, lanes, fraction_bits);
  Real worst = 0;
  for (int t = 0; t < length; t += lanes, model.Step()) {
    for (int lane = 0; lane < lanes && t + lane < length; ++lane) {
      const Real error =
          std::ldexp(std::abs(ToReal(model.value(lane)) - arc.At(t + lane)), fraction_bits);
      worst = std::max(worst, error);
      if (check && error > Bound(lanes, fraction_bits, arc.phi, t + lane)) {
        ADD_FAILURE() << "F " << fraction_bits << " lanes " << lanes << " phi "
                      << static_cast<double>(arc.phi) << " pixel " << t + lane << " error "
                      << static_cast<double>(error);
        return worst;
      }
    }
  }
  return worst;
}

Real WorstOfArcs(int length, int lanes, int fraction_bits, int arcs) {
  std::mt19937 random(static_cast<uint32_t>(length));
  Real worst = 0;
  while (arcs-- > 0) {
    const Arc arc = RandomArc(length, random);
    worst = std::max(worst, WorstError(arc, length, lanes, fraction_bits, true));
  }
  return worst;
}

void ExpectPageRow(const PageRow& row, int lanes) {
  SCOPED_TRACE(std::to_string(lanes) + " lanes, F " + std::to_string(row.fraction_bits));
  for (size_t i = 0; i < kLengths.size(); ++i) {
    const Real worst = WorstOfArcs(kLengths[i], lanes, row.fraction_bits, 60);
    EXPECT_LE(worst, 1.01L * row.worst[i]) << kLengths[i] << " pixels";
    EXPECT_GT(worst, 0.5L * row.worst[i]) << kLengths[i] << " pixels";
  }
}

TEST(SlerpPaper, ErrorGrowsWithTheSquareOfTheLength) {
  for (const PageRow& row : kOneLanePage) ExpectPageRow(row, 1);
  for (const PageRow& row : kFourLanesPage) ExpectPageRow(row, 4);
}

TEST(SlerpPaper, PageHasTheErrors) {
  std::ifstream file(SHADESIM_ROOT "/docs/units/normal/slerp_paper.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  for (const PageRow& row : kOneLanePage) {
    EXPECT_NE(page.find(LineOf(row)), std::string::npos) << LineOf(row);
    // What is printed is the last error, in two digits.
    const double part = std::ldexp(row.worst.back(), -row.fraction_bits);
    EXPECT_NEAR(std::stod(row.of_full_scale), part, 0.05 * part);
  }
  for (const PageRow& row : kFourLanesPage) {
    EXPECT_NE(page.find(LineOf(row)), std::string::npos) << LineOf(row);
  }
}

// Random arcs, then small moves away from the worst of them.
TEST(SlerpPaper, ModelWithinErrorBound) {
  std::mt19937 random(1);
  std::normal_distribution<double> move(0, 1);
  Arc worst_arc{};
  Real worst = 0;
  for (int i = 0; i < 1200; ++i) {
    Arc arc = RandomArc(kBoundedLength, random);
    if (i > 400) {
      const Real size = 1e-2L * std::pow(0.99L, static_cast<Real>(i - 400));
      arc = {worst_arc.phi * (1 + size * static_cast<Real>(move(random))),
             worst_arc.start + size * static_cast<Real>(move(random))};
    }
    const Real error = WorstError(arc, kBoundedLength, 1, 38, i % 8 == 0);
    if (error > worst) worst = error, worst_arc = arc;
  }
  RecordProperty("worst_ulp38_2048", static_cast<int>(worst));
  RecordProperty("worst_turn_microradians",
                 static_cast<int>(worst_arc.phi * kBoundedLength * 1e6L));
  EXPECT_LE(worst, SlerpPaper::kContract.max_error_ulp);
  EXPECT_LE(Bound(1, 38, 1e-9L, kBoundedLength - 1), SlerpPaper::kContract.max_error_ulp);
  EXPECT_GT(worst, 0.9L * SlerpPaper::kContract.max_error_ulp) << "the search is blind";
}

TEST(SlerpPaper, DeadZoneIsAStraightLine) {
  // 30 degrees in 256 pixels: phi^2 is under half an ulp of 16 bits, 2 cos(phi) becomes 2.
  const Arc arc{kQuarterTurn / 3 / 255, 0.4L};
  const QuantityStart start = arc.Start();
  SlerpPaper model(start.seed, start.step_kappa, 1, 16);
  const Quantity first = model.value();
  model.Step();
  const int64_t difference = model.value().raw() - first.raw();
  for (int t = 1; t < 256; ++t, model.Step()) {
    ASSERT_EQ(model.value().raw(), first.raw() + difference * t);
  }
  const Real worst = WorstError(arc, 256, 1, 16, true);
  RecordProperty("dead_zone_error_ppm", static_cast<int>(std::ldexp(worst, -16) * 1e6L));
  EXPECT_GT(std::ldexp(worst, -16), 0.05L);
}

// N(t+3), N(t+4) from N(t), N(t-1).
struct FarPixels {
  Real third, fourth;
};

FarPixels Corrected(Real phi, Real now, Real before) {
  const Real c = 2 * std::cos(phi), cc = 2 * std::cos(2 * phi);
  return {cc * (c * now - before) - before, cc * ((cc + 1) * now - c * before) - now};
}

FarPixels Printed(Real phi, Real now, Real before) {
  const Real c = std::cos(phi), cc = std::cos(2 * phi);
  return {cc * (4 * c * now - before) - 3 * before,
          2 * now * cc * (2 * cc + 3) - 2 * before * c * (cc + 4) + now};
}

TEST(SlerpPaper, PrintedFarPixelsAreWrongCorrectedOnesAreRight) {
  for (const Real phi : {1e-6L, 1e-3L, 0.1L}) {
    const Arc arc{phi, 0.5L};
    const FarPixels right = Corrected(phi, arc.At(0), arc.At(-1));
    EXPECT_LT(std::abs(right.third - arc.At(3)), 1e-17L);
    EXPECT_LT(std::abs(right.fourth - arc.At(4)), 1e-17L);
  }
  const Arc arc{1e-3L, 0.5L};
  const FarPixels wrong = Printed(arc.phi, arc.At(0), arc.At(-1));
  const Real difference = arc.At(0) - arc.At(-1);
  EXPECT_NEAR(static_cast<double>(arc.At(3)), 0.8761, 1e-4);
  EXPECT_NEAR(static_cast<double>(wrong.third), -0.0019, 1e-4);
  EXPECT_NEAR(static_cast<double>((arc.At(4) - arc.At(0)) / difference), 4, 0.03);
  EXPECT_NEAR(static_cast<double>((wrong.fourth - arc.At(0)) / difference), 10, 0.1);
}

TEST(SlerpPaper, SixtyDegreesAStepRepeatsExactly) {
  QuantityStart start;
  start.seed[0] = {Quantity::Round(1), Quantity::Round(-0.5)};
  start.step_kappa[0] = {U<1, 28>::Round(1), 0};
  SlerpPaper model(start.seed, start.step_kappa);
  constexpr std::array<double, 6> kTurn = {1, 0.5, -0.5, -1, -0.5, 0.5};
  for (size_t t = 0; t < 600; ++t, model.Step()) EXPECT_EQ(model.value().ToReal(), kTurn[t % 6]);
}

TEST(SlerpPaper, OverflowWrapsAtTheStateFormat) {
  // 1.5, 1.75 on a line: 2 wraps to -2.
  QuantityStart start;
  start.seed[0] = {Quantity::Round(1.5), Quantity::Round(0.25)};
  for (const int fraction_bits : {8, 16, 38}) {
    SlerpPaper model(start.seed, start.step_kappa, 1, fraction_bits);
    for (const double value : {1.5, 1.75, -2.0, -1.75}) {
      EXPECT_EQ(model.value().ToReal(), value);
      model.Step();
    }
  }
  // The largest seed rounds up to 2.
  start.seed[0] = {Quantity::Wrap(2 * kOneQuantity - 1), {}};
  EXPECT_EQ(SlerpPaper(start.seed, start.step_kappa, 1, 16).value().ToReal(), -2);
}

}  // namespace
}  // namespace shading
