// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "model/contracts.h"
#include "sim/stress/model_value.h"
#include "sim/stress/narrow_paper.h"
#include "sim/stress/stress_results.h"
#include "sim/stress/triangle_genes.h"
#include "sim/stress/vectors.h"

namespace shading::stress {
namespace {

int64_t RawOf(std::mt19937& random, int bits) {
  return static_cast<int64_t>(random() % (uint64_t{1} << bits)) - (int64_t{1} << (bits - 1));
}

// What the units accumulate, from what they show.
TEST(StressPieces, AccumulatorsAreReadToTheLastBit) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    const int64_t first = RawOf(random, 31), difference = RawOf(random, 20);
    const int64_t curvature = RawOf(random, 10), steps = random() % 300;
    const ChannelSeed seed = {IntensityAcc::Wrap(first),
                              {},
                              IntensityAcc::Wrap(difference),
                              IntensityAcc::Wrap(curvature)};
    const int64_t bent = first + steps * difference + steps * (steps - 1) / 2 * curvature;
    EXPECT_EQ(AfterSteps(BasicQuadDifference<SeenWord>(seed), static_cast<int>(steps)),
              IntensityAcc::Wrap(bent).raw());
    EXPECT_EQ(GouraudAfter(first, difference, static_cast<int>(steps)),
              IntensityAcc::Wrap(first + steps * difference).raw());
    const int64_t depth = (int64_t{1} << 36) + RawOf(random, 31);
    EXPECT_EQ(DepthAfter(depth, difference, static_cast<int>(steps)), depth + steps * difference);
  }
}

Genes RandomGenes(size_t count, std::mt19937& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  Genes genes(count);
  for (double& gene : genes) gene = unit(random);
  return genes;
}

TEST(StressPieces, FarPixelsAreCoveredAndRowsAreWhole) {
  std::mt19937 random(2);
  int covered = 0;
  for (int i = 0; i < 3000; ++i) {
    const TrianglePacket packet = CornersOf(RandomGenes(7, random), 64, 48);
    TriangleGeometry geometry;
    if (TriangleSetup::Setup(packet, FrameOf(64, 48), &geometry) != Verdict::kDraw) continue;
    const ExactWeights exact(packet);
    EXPECT_TRUE(exact.At(0, 5, 7) + exact.At(1, 5, 7) + exact.At(2, 5, 7) == exact.area());
    for (const auto& [x, y] : FarPixels(exact, geometry)) ASSERT_TRUE(exact.Covers(x, y));
    const int y = static_cast<int>(random() % 48);
    const auto [first, end] = exact.Row(y, 0, 64);
    for (int x = 0; x < 64; ++x) ASSERT_EQ(exact.Covers(x, y), x >= first && x < end) << i;
    covered += first < end;
  }
  EXPECT_GT(covered, 500);
}

TEST(StressPieces, OpposedNormalsAreOpposed) {
  std::mt19937 random(3);
  for (int i = 0; i < 1000; ++i) {
    Genes g = RandomGenes(8, random);
    g[2] = 0.5;  // 2^-11
    const auto n = NearNormals(g, 0, true);
    Real square = 0;
    for (size_t c = 0; c < 3; ++c) square += std::pow(n[0][c].ToReal() + n[1][c].ToReal(), 2);
    EXPECT_LT(square, 0x1p-20);
  }
}

TEST(StressPieces, NoNumberCountsAsInfinite) {
  Real worst = 1;
  Raise(&worst, 0.5L);
  EXPECT_EQ(worst, 1);
  Raise(&worst, std::nanl(""));
  Raise(&worst, 2);
  EXPECT_TRUE(std::isinf(worst));
  Check check;
  check.genes = {"a"};
  check.error = [](const Genes& g, int) { return g[0] > 0.9 ? std::nan("") : g[0]; };
  EXPECT_TRUE(std::isinf(Search(check, 300, 1).error));
  EXPECT_TRUE((Condition{"", "", "", 1, std::nan(""), 1, -1}.Broken()));
}

// (t^2 + t + 1) / 2 ulps to first order, twice that truncated.
TEST(StressPieces, NarrowPaperGrowsAsItsProof) {
  constexpr int kBits = 30, kLast = 1000;
  for (const bool truncate : {false, true}) {
    Real worst = 0;
    for (int phase = 0; phase < 20; ++phase) {
      const Arc arc{0.001L, 0.3L * phase};
      NarrowPaper unit(arc, kBits, truncate);
      for (int t = 0; t < kLast; ++t) unit.Step();
      Raise(&worst, std::abs(static_cast<Real>(unit.value()) - std::ldexp(arc.At(kLast), kBits)));
    }
    const Real bound = (kLast * (kLast + 1) + 1) / 2.0L;
    EXPECT_LT(worst, truncate ? 2 * bound : bound);
    EXPECT_GT(worst, bound / 8);
  }
}

TEST(StressParts, GoThroughJsonUnchanged) {
  StressResults results, again;
  results.quick = again.quick = true;
  const auto parts = PartsOf("subdivision", &results), copies = PartsOf("subdivision", &again);
  ASSERT_EQ(parts.size(), 1u);
  const PartJson done = parts[0].run();
  parts[0].take(done);
  copies[0].take(PartJson::parse(done.dump()));
  EXPECT_EQ(results.findings[0].worst.error, again.findings[0].worst.error);
  EXPECT_EQ(results.findings[0].worst.genes, again.findings[0].worst.genes);
  EXPECT_TRUE(results.findings[0].Broken());
  EXPECT_EQ(results.Broken(), 1);
  EXPECT_TRUE(PartsOf("teapot", &results).empty());
}

TEST(StressParts, HaveNamesOfTheirOwn) {
  StressResults results;
  std::set<std::string> ids;
  const auto parts = PartsOf("", &results);
  for (const Part& part : parts) ids.insert(part.id);
  EXPECT_EQ(ids.size(), parts.size());
}

// Every condition holds, and its measure is not blind.
class EveryScene : public testing::TestWithParam<size_t> {};

TEST_P(EveryScene, Holds) {
  const Condition c = AllScenes()[GetParam()](true, 1);
  EXPECT_FALSE(c.Broken()) << c.scene << ": " << c.measure << ' ' << c.worst << " of " << c.limit;
  EXPECT_GT(c.cases, 0) << c.scene;
  if (c.limit > 0) {
    EXPECT_GT(c.worst, 0) << c.scene << ": the search is blind";
  }
  if (c.naive >= 0) {
    EXPECT_GT(c.naive, 50) << "the trap is none";
  }
}

INSTANTIATE_TEST_SUITE_P(All, EveryScene, testing::Range(size_t{0}, AllScenes().size()));

}  // namespace
}  // namespace shading::stress
