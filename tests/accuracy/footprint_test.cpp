// SPDX-License-Identifier: Apache-2.0
//
// Errors of footprints against 4096 points of the ellipse, and against an independent study of
// them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/accuracy/footprint_plane.h"
#include "tests/accuracy/footprint_raster.h"
#include "tests/accuracy/footprint_seam.h"

namespace shading::accuracy {
namespace {

constexpr double kFactor = 1.3;

// Axes 1:4; codes of a small-angle model in floating point. Its four samples lie on the major axis,
// those of the unit on both, so that only the unit's may be better.
struct Study {
  int n;
  double turn, centre, two, four;
};
constexpr std::array<Study, 5> kStudy = {{{32, 5, 8.0, 0.37, 0.44},
                                          {128, 1, 1.3, 0.07, 0.08},
                                          {128, 2, 5.2, 0.26, 0.29},
                                          {128, 5, 29, 1.9, 1.4},
                                          {128, 10, 88, 13, 5.8}}};

void ExpectWithin(double actual, double expected) {
  EXPECT_LE(actual, kFactor * expected);
  EXPECT_GE(actual, expected / kFactor);
}

TEST(FootprintAccuracy, PlaneAgreesWithTheStudy) {
  for (const Study& study : kStudy) {
    SCOPED_TRACE(std::to_string(study.n) + ", " + std::to_string(study.turn));
    const PlaneErrors errors = ErrorsOnPlane(4, study.turn, study.n, 21);
    ExpectWithin(errors.pattern[0].max, study.centre);
    ExpectWithin(errors.pattern[1].max, study.two);
    EXPECT_LE(errors.pattern[2].max, kFactor * study.four);
    EXPECT_LE(errors.pattern[3].max, kFactor * study.four);
  }
}

// The centre alone keeps half a code up to about 7 / sqrt(n) degrees.
TEST(FootprintAccuracy, CentreAloneUpToSevenDegrees) {
  for (const int n : {8, 32, 128}) {
    const double limit = 7 / std::sqrt(n);
    ExpectWithin(ErrorsOnPlane(4, limit, n, 11).pattern[0].max, 0.5);
  }
}

// What the set-up chooses keeps its half code, for every shape. Diffuse light has a kink at the
// terminator, see below.
TEST(FootprintAccuracy, ChosenPatternKeepsHalfACode) {
  int fewer = 0;
  for (const double ratio : {1., 2., 4., 8., 16.}) {
    for (const int n : {8, 32, 128}) {
      for (const double scaled : {3., 6., 9., 14., 20., 28., 40., 56.}) {  // turn sqrt(n)
        const double turn = scaled / std::sqrt(n);
        if (turn > 15) continue;
        const PlaneErrors errors = ErrorsOnPlane(ratio, turn, n, 9);
        const auto chosen = static_cast<size_t>(errors.chosen);
        EXPECT_LE(errors.pattern[chosen].max, 0.51)
            << ratio << ", n " << n << ", turn " << turn << ", pattern " << chosen;
        fewer += chosen < 3;
      }
    }
  }
  EXPECT_GT(fewer, 50) << "the choice is always the most expensive";
}

// On the terminator max(0, x) has the mean 2 a / 3 pi over the ellipse, and a / 4 or 0 from two
// samples or one: errors of 0.212 and 0.038 255 a codes for a turn a, whatever the shape.
TEST(FootprintAccuracy, TerminatorIsAKink) {
  constexpr double kTurn = 5;
  const double full = 255 * std::tan(kTurn * std::acos(-1) / 180);
  for (const double ratio : {4., 16.}) {
    const PlaneErrors errors = ErrorsOnPlane(ratio, kTurn, 1, 41);
    ExpectWithin(errors.pattern[0].max, 0.212 * full);
    EXPECT_LT(errors.pattern[1].max, 0.08 * full);
    EXPECT_LT(errors.pattern[2].max, 0.08 * full);
    EXPECT_LT(errors.pattern[3].max, 0.05 * full);
  }
}

TEST(FootprintAccuracy, TrianglesAreLikeThePlane) {
  for (const bool perspective : {false, true}) {
    for (const double ratio : {1., 4., 16.}) {
      const RasterCase c = {FootprintForm::kSeamless, ratio, 2, 32, perspective};
      std::array<double, 4> worst;
      for (size_t p = 0; p < worst.size(); ++p) {
        FootprintSetup::Options options;
        options.least = options.most = static_cast<FootprintPattern>(p);
        worst[p] = ErrorsOnTriangles(c, options, 4).errors.max;
      }
      EXPECT_GT(worst[0], 0.8);
      EXPECT_LT(worst[0], 3.0);
      EXPECT_LT(worst[1], ratio == 1 ? 1.5 : 0.12);
      EXPECT_LT(worst[2], 0.01);
      EXPECT_LT(worst[3], 0.006);
      EXPECT_LE(ErrorsOnTriangles(c, {}, 4).errors.max, 0.5);
    }
  }
}

TEST(FootprintAccuracy, PaperFormIsTheMeanOfItsTriangle) {
  FootprintSetup::Options options;
  options.least = options.most = FootprintPattern::kEight;
  const RasterErrors errors =
      ErrorsOnTriangles({FootprintForm::kPaper, 4, 1, 32, false}, options, 4);
  EXPECT_LT(errors.errors.max, 0.006);
}

// How far the enlarged triangle moves normals, degrees, by the study; and what the shared edge
// sees.
TEST(FootprintAccuracy, PaperFormMovesNormals) {
  struct Moved {
    double spread, degrees;
  };
  for (const Moved& study : {Moved{10, 0.12}, {20, 1.0}, {30, 3.8}}) {
    const SeamErrors errors = SearchSeams(study.spread, 500);
    ExpectWithin(errors.moved, study.degrees);
    EXPECT_GT(errors.edge, 0.5 * errors.moved);
    EXPECT_LE(errors.edge, 2 * errors.moved);
  }
}

}  // namespace
}  // namespace shading::accuracy
