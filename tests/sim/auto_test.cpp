// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "model/raster/front_end.h"
#include "model/shading_unit.h"
#include "sim/bench/auto_table.h"
#include "sim/bench/measure.h"
#include "sim/scene/builtin.h"
#include "sim/scene/camera.h"
#include "tb/stimulus/random_triangles.h"

namespace shading::sim {
namespace {

FrameWork AutoWork(const TriangleList& list, double tolerance) {
  FrontEndOptions options;
  options.tolerance = Tolerance::Round(tolerance);
  return FrontEnd::Run(list, Method::kAuto, options);
}

// The picture by the model.
FrameBuffer Shade(const TriangleList& list, const FrameWork& work) {
  FrameBuffer picture(list.frame.width, list.frame.height);
  ShadingUnit unit(work, 1, FlowPattern::Always(), FlowPattern::Always());
  std::vector<Pixel> pixels(kMaxScreen);
  size_t triangle = 0;
  ForEachSpan(
      work, [&](size_t t) { unit.Triangle(work.triangles[triangle = t]); },
      [&](const SpanCommand& span) {
        unit.Span(span, pixels.data());
        for (int i = 0; i < span.length; ++i) {
          picture.Put(pixels[static_cast<size_t>(i)], static_cast<int32_t>(work.packet[triangle]));
        }
        return true;
      });
  return picture;
}

void ExpectWithin(const TriangleList& list, double tolerance) {
  const FrameWork work = AutoWork(list, tolerance);
  EXPECT_LE(ErrorAgainstPhong(Shade(list, work), list).max_lsb, tolerance + kBeyondTolerance);
}

TriangleList Scene(const std::string& name) {
  ViewOptions view;
  view.width = view.height = 96;
  return Project(MakeBuiltin(name), view);
}

TEST(Auto, StaysWithinItsToleranceOnScenes) {
  for (const char* name : {"builtin:sphere:12", "builtin:torus:16", "builtin:saddle:6",
                           "builtin:mixed:3", "builtin:panel:8", "builtin:cylinder:16"}) {
    const TriangleList scene = Scene(name);
    for (const int n : {1, 2, 8, 32, 128}) {
      const TriangleList list = WithShininess(scene, n);
      for (const double tolerance : {0.5, 1., 2., 4.}) {
        SCOPED_TRACE(testing::Message() << name << ", n " << n << ", tolerance " << tolerance);
        ExpectWithin(list, tolerance);
      }
    }
  }
}

TEST(Auto, StaysWithinItsToleranceOnRandomTriangles) {
  for (uint32_t seed = 1; seed <= 30; ++seed) {
    const TriangleList list = tb::RandomTriangles(seed, 60);
    for (const double tolerance : {0.5, 1., 2., 4.}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", tolerance " << tolerance);
      ExpectWithin(list, tolerance);
    }
  }
}

TEST(Auto, EveryMethodHasItsUse) {
  std::array<int64_t, kMethodCount> triangles = {};
  for (uint32_t seed = 1; seed <= 20; ++seed) {
    const FrameWork work = AutoWork(tb::RandomTriangles(seed, 100), 1);
    for (size_t m = 0; m < triangles.size(); ++m) triangles[m] += work.share[m].triangles;
  }
  const FrameWork mixed = AutoWork(Scene("builtin:mixed"), 1);
  for (size_t m = 0; m < triangles.size(); ++m) triangles[m] += mixed.share[m].triangles;
  for (const Method method : {Method::kFlat, Method::kGouraud, Method::kQuad, Method::kQuadCosine,
                              Method::kPhongSurface, Method::kPhongDuff}) {
    EXPECT_GT(triangles[static_cast<size_t>(method)], 0) << Name(method);
  }
}

// The table takes measured cells: with auto, phong and two that miss the tolerance.
TEST(Auto, BestSingleIsTheFastestThatIsAsGood) {
  Results results;
  const auto add = [&](Method method, double tolerance, int64_t cycles, double error) {
    Cell cell;
    cell.key = {"scene", method, 8, tolerance, 1};
    cell.work.pixels = 100;
    cell.cycles = cycles;
    cell.phong.max_lsb = error;
    cell.sure = 1U << static_cast<unsigned>(Method::kPhong) |
                1U << static_cast<unsigned>(Method::kPhongDuff);
    results.cells.push_back(cell);
  };
  add(Method::kAuto, 1, 105, 1.2);
  add(Method::kFlat, 0, 100, 40);
  add(Method::kQuad, 0, 104, 1.91);
  add(Method::kQuadStep, 0, 103, 1.93);
  add(Method::kPhong, 0, 120, 0.5);
  const auto best = [&](Judged judged) {
    const Cell* cell = BestSingle(results, results.cells[0], judged);
    return cell == nullptr ? Method::kAuto : cell->key.method;
  };
  EXPECT_EQ(best(Judged::kAfter), Method::kQuad);
  EXPECT_EQ(best(Judged::kBefore), Method::kPhong);
  EXPECT_NE(AutoTable(results).Markdown().find("+1.0 %"), std::string::npos) << "of 104";
  EXPECT_NE(AutoTable(results).Markdown().find("-12.5 %"), std::string::npos) << "of 120";
}

}  // namespace
}  // namespace shading::sim
