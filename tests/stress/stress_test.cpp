// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "model/contracts.h"
#include "sim/stress/growth.h"
#include "sim/stress/narrow_recurrence.h"
#include "sim/stress/search.h"
#include "sim/stress/stress_page.h"

namespace shading::stress {
namespace {

int64_t Evaluations(const Check& check) { return std::max<int64_t>(300000 / check.cost, 24); }

class EveryUnit : public testing::TestWithParam<Check> {};

TEST_P(EveryUnit, HoldsItsBoundAndBreaksItWithABitLess) {
  const Check& check = GetParam();
  const Worst as_stated = Search(check, Evaluations(check), 1);
  EXPECT_LE(as_stated.error, check.bound);
  EXPECT_GT(as_stated.error, check.blind * check.bound) << "the search is blind";
  EXPECT_EQ(check.error(as_stated.genes, 0), as_stated.error) << "the case can be replayed";
  EXPECT_EQ(as_stated.genes.size(), check.genes.size());
  EXPECT_GT(Search(check, Evaluations(check), 1, 1).error, check.bound) << check.narrowed;
}

INSTANTIATE_TEST_SUITE_P(All, EveryUnit, testing::ValuesIn(AllChecks()),
                         [](const auto& test) { return test.param.unit; });

TEST(Stress, EveryUnitIsSearchedOrHasAReason) {
  EXPECT_EQ(AllChecks().size() + Exemptions().size(), kContracts.size());
  for (const Exempt& exempt : Exemptions()) EXPECT_FALSE(exempt.reason.empty()) << exempt.unit;
}

TEST(Stress, NarrowRecurrenceIsTheUnitAtFullWidth) {
  for (const Real phi : {1e-6L, 1e-4L, 0.01L, 0.3L}) {
    for (const Real start : {-0.2L, 0.7L, 2.0L}) {
      const Arc arc{phi, start};
      NarrowRecurrence narrow(arc, 38);
      SlerpRecurrence unit({Quantity::Wrap(RoundTo(arc.At(0), 38)),
                            Quantity::Wrap(RoundTo(arc.FirstDifference(), 38))},
                           KappaOf(phi));
      for (int t = 0; t < 500; ++t, narrow.Step(), unit.Step())
        ASSERT_EQ(narrow.value(), unit.value().raw()) << t;
    }
  }
}

TEST(Stress, SearchClimbsToAHiddenPeak) {
  Check check;
  check.genes = {"a", "b"};
  check.error = [](const Genes& g, int) { return 2 - std::hypot(g[0] - 0.37, g[1] - 0.81); };
  const Worst worst = Search(check, 60000, 1);
  EXPECT_NEAR(worst.genes[0], 0.37, 1e-6);
  EXPECT_NEAR(worst.genes[1], 0.81, 1e-6);
}

TEST(Stress, NarrowedRoundsHalfUp) {
  EXPECT_EQ(Narrowed(5, 0), 5);
  EXPECT_EQ(Narrowed(5, 1), 6);
  EXPECT_EQ(Narrowed(-5, 1), -4);
  EXPECT_EQ(Narrowed(6, 2), 8);
}

TEST(Stress, DeadZoneDrawsAStraightLine) {
  const double degrees = 0.9 * DeadZone(20, 256);
  const Arc arc{kPi / 180 * static_cast<Real>(degrees) / 255, 0};
  NarrowRecurrence line(arc, 20);
  const int64_t first = line.value();
  line.Step();
  const int64_t step = line.value() - first;
  for (int t = 1; t < 256; ++t, line.Step()) ASSERT_EQ(line.value(), first + step * t);
}

TEST(Stress, PageMarksABrokenBound) {
  StressResults results;
  results.findings.push_back({AllChecks()[0], {2 * AllChecks()[0].bound, {0, 0}, 7}, 1});
  EXPECT_NE(StressPage(results).find("BROKEN"), std::string::npos);
  EXPECT_TRUE(StressJson(results)["units"][0]["broken"]);
}

}  // namespace
}  // namespace shading::stress
