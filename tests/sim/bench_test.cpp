// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "sim/bench/fingerprint.h"
#include "sim/bench/measure.h"
#include "sim/bench/pareto.h"
#include "sim/scene/builtin.h"
#include "sim/scene/camera.h"
#include "tests/accuracy/quad_table.h"

namespace shading::sim {
namespace {

TEST(Pareto, IsTheSetThatNoPointDominates) {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    std::vector<CostError> points(1 + random() % 30);
    // A coarse grid, so that equal points and equal costs are common.
    for (CostError& p : points)
      p = {static_cast<double>(random() % 8), static_cast<double>(random() % 8)};
    std::vector<size_t> expected;
    for (size_t i = 0; i < points.size(); ++i) {
      const bool dominated = std::any_of(points.begin(), points.end(), [&](const CostError& p) {
        return p.cost <= points[i].cost && p.error <= points[i].error &&
               (p.cost < points[i].cost || p.error < points[i].error);
      });
      if (!dominated) expected.push_back(i);
    }
    std::vector<size_t> front = ParetoFront(points);
    EXPECT_TRUE(std::is_sorted(front.begin(), front.end(), [&](size_t a, size_t b) {
      return points[a].cost < points[b].cost;
    }));
    std::sort(front.begin(), front.end());
    EXPECT_EQ(front, expected) << "round " << round;
  }
}

TEST(Pareto, UnknownCostsAreNeverOnIt) {
  EXPECT_EQ(ParetoFront({{INFINITY, 0}, {1, NAN}, {2, 3}}), std::vector<size_t>{2});
  EXPECT_TRUE(ParetoFront({}).empty());
}

// The row forms of paper 003, against what their models are seen to do.
TEST(CostModel, RowFormsAreCountedInTheModels) {
  const std::map<std::string, Method> kForms = {
      {"quad_polynomial", Method::kQuadPolynomial},
      {"quad_horner", Method::kQuadHorner},
      {"quad_step", Method::kQuadStep},
      {"quad_surface", Method::kQuad},
      {"quad_midpoint", Method::kQuadMidpoint},
      {"quad_three_term", Method::kQuadThreeTerm},
      {"quad_third_difference", Method::kQuadThirdDifference},
      {"quad_difference", Method::kQuadDifference},
      {"quad_segment", Method::kQuadSegment}};
  size_t compared = 0;
  for (const accuracy::UnitRow& row : accuracy::UnitRows()) {
    SCOPED_TRACE(row.unit);
    const Operations pixel = CostOf(kForms.at(row.unit)).pixel;  // three channels
    const auto counted = [](int n) { return 3.0 * n / accuracy::kUnitPixels; };
    EXPECT_NEAR(pixel.multiplications, counted(row.pixels.multiplications), 1e-9);
    EXPECT_NEAR(pixel.additions, counted(row.pixels.additions), 0.1);
    EXPECT_NEAR(pixel.shifts, counted(row.pixels.shifts), 0.2);
    ++compared;
  }
  EXPECT_EQ(compared, kForms.size());
}

TEST(CostModel, EveryMethodIsCounted) {
  for (const Method method : kAllMethods) {
    const MethodCost cost = CostOf(method);
    EXPECT_FALSE(cost.reason.empty()) << Name(method);
    EXPECT_GT(cost.triangle.total() + cost.pixel.total(), 0) << Name(method);
    if (method == Method::kAuto) continue;  // its pixels are those of the chosen methods
    EXPECT_EQ(LightsPixels(method), cost.highlight.total() + cost.sample.total() > 0)
        << Name(method);
  }
}

// Paper 003: a product 8, an addition and a shift 1.
TEST(CostModel, CyclesAreThoseOfThePaper) {
  EXPECT_EQ(PaperCycles({6, 37, 29, 0}), 114) << "table 1, (5)";
  EXPECT_EQ(PaperCycles({80, 80, 0, 0}), 720) << "table 1, (9)";
  const MethodCost cost = CostOf(Method::kQuad);
  EXPECT_EQ(PaperCycles(TotalOf(cost, {1, 2, 30, 0, 0})),
            PaperCycles(cost.triangle) + 2 * PaperCycles(cost.span) + 30 * PaperCycles(cost.pixel));
}

TriangleList SmallScene() {
  ViewOptions view;
  view.width = 48;
  view.height = 36;
  return Project(MakeBuiltin("builtin:sphere:3"), view);
}

TEST(Measure, EveryCycleIsOfOneKind) {
  const TriangleList list = SmallScene();
  IdealCache ideals;
  for (const Method method : {Method::kFlat, Method::kQuad, Method::kSlerp}) {
    for (const int lanes : {1, kMaxLanes}) {
      FrameBuffer picture(48, 36);
      const Cell cell = MeasureCell(list, {"sphere", method, 32, 0, lanes}, 1, &picture, &ideals);
      SCOPED_TRACE(cell.key.Text());
      EXPECT_EQ(cell.busy + cell.fill + cell.setup + cell.stall, cell.cycles);
      EXPECT_GE(cell.setup, 0);
      EXPECT_GT(cell.fill, 0);
      EXPECT_EQ(cell.stall, 0) << "pixels are always taken";
      EXPECT_GE(cell.busy * lanes, cell.work.pixels);
      if (lanes == 1) {
        EXPECT_EQ(cell.busy, cell.work.pixels);
      }
      EXPECT_LE(cell.closed_form.max_lsb, 0.75);
      EXPECT_GT(cell.model_seconds, 0);
    }
  }
}

TEST(Measure, LatencyIsThatOfTheContract) {
  const SpanCurve curve = MeasureSpans(Method::kQuad, 1, {16}, 8);
  EXPECT_EQ(curve.latency, ShadingUnit::kContract.latency_cycles);
  EXPECT_EQ(curve.CyclesOf(16), 16);
}

// Lanes, tolerances and methods of one closed form share it, whatever goes to keep the budget.
TEST(Measure, SharedClosedFormsAreThoseOfThePicture) {
  const TriangleList one = WithShininess(SmallScene(), 1), many = WithShininess(SmallScene(), 128);
  IdealCache roomy, tight(1);
  for (const Method method : {Method::kFlat, Method::kSlerp, Method::kSlerpPaper, Method::kPhong}) {
    for (const int lanes : {1, kMaxLanes}) {
      for (const int n : {1, 128}) {
        const TriangleList& list = n == 1 ? one : many;
        for (IdealCache* ideals : {&roomy, &tight}) {
          FrameBuffer picture(48, 36);
          const Cell cell = MeasureCell(list, {"s", method, n, 0, lanes}, 1, &picture, ideals);
          SCOPED_TRACE(cell.key.Text());
          EXPECT_EQ(cell.phong.rms_lsb, ErrorAgainstPhong(picture, list).rms_lsb);
          const PictureError direct = ErrorAgainstClosedForm(picture, list, method);
          EXPECT_EQ(cell.closed_form.rms_lsb, direct.rms_lsb);
          EXPECT_EQ(cell.closed_form.max_lsb, direct.max_lsb);
        }
      }
    }
  }
  EXPECT_EQ(roomy.computed(), 2 * 3) << "flat, slerp and phong at each n";
  EXPECT_GT(tight.computed(), 2 * 3);
}

TEST(Measure, APictureOfOtherTrianglesIsNotJudgedByTheWrongOnes) {
  const TriangleList list = SmallScene();
  IdealCache ideals;
  const CellKey key = {"s", Method::kPhong, 1, 0, 1};
  FrameBuffer picture(48, 36), empty(48, 36);
  MeasureCell(list, key, 1, &picture, &ideals);
  Pixel pixel;
  pixel.x = 20;
  pixel.y = 20;
  empty.Put(pixel, 0);
  EXPECT_EQ(ideals.ErrorOf(key, Method::kPhong, empty, list).max_lsb,
            ErrorAgainstPhong(empty, list).max_lsb);
}

TEST(Measure, ShininessIsThatOfTheKey) {
  const TriangleList list = SmallScene();
  IdealCache ideals;
  FrameBuffer low(48, 36), high(48, 36);
  MeasureCell(WithShininess(list, 1), {"sphere", Method::kPhong, 1, 0, 1}, 1, &low, &ideals);
  MeasureCell(WithShininess(list, 128), {"sphere", Method::kPhong, 128, 0, 1}, 1, &high, &ideals);
  int64_t sum = 0;
  for (size_t at = 0; at < low.size(); ++at) sum += low.code(at)[0] - high.code(at)[0];
  EXPECT_GT(sum, 1000) << "a wide highlight is brighter";
  EXPECT_NE(Fingerprint(WithShininess(list, 1)), Fingerprint(WithShininess(list, 128)));
}

TEST(Measure, LongSpansTakeTheirPixelsShortOnesTheirSetUp) {
  const SpanCurve one = MeasureSpans(Method::kSlerp, 1, {1, 16, 64}, 12);
  EXPECT_EQ(one.CyclesOf(1), 8);
  EXPECT_EQ(one.CyclesOf(16), 16);
  EXPECT_EQ(one.CyclesOf(60), 64) << "the nearest";
  EXPECT_EQ(MeasureSpans(Method::kFlat, 4, {64}, 12).CyclesOf(64), 16);
  // 10 degrees in parts of at most 2.54: 3 levels, done beside the pixels.
  EXPECT_EQ(MeasureSpans(Method::kAdaptive, 1, {64}, 12).CyclesOf(64), 64);
}

}  // namespace
}  // namespace shading::sim
