// SPDX-License-Identifier: Apache-2.0
//
// Every exact form of paper 003 shows the same pixels: a surface that S9.26 represents has no error
// that could tell them apart.
#include <gtest/gtest.h>

#include <vector>

#include "model/intensity/quad_difference.h"
#include "model/intensity/quad_horner.h"
#include "model/intensity/quad_midpoint.h"
#include "model/intensity/quad_polynomial.h"
#include "model/intensity/quad_segment.h"
#include "model/intensity/quad_step.h"
#include "model/intensity/quad_surface.h"
#include "model/intensity/quad_third_difference.h"
#include "model/intensity/quad_three_term.h"
#include "tests/unit/intensity/point_stimulus.h"
#include "tests/unit/intensity/real_curve.h"

namespace shading {
namespace {

template <typename Form>
class QuadForms : public testing::Test {
 protected:
  // Shown intensities, before their clamp, of the form and of the closed form.
  static void ExpectSamePixels(const ChannelSeed& seed, int length) {
    QuadSurface surface(seed);
    Form form(seed);
    for (int t = 0; t < length; ++t, surface.Step(), form.Step()) {
      const int64_t value = IntensityAcc::Wrap(static_cast<int64_t>(CurveAt(seed, t))).raw();
      ASSERT_GE(value, -86 * kOneCode) << "a pixel out of range";
      ASSERT_LE(value, 341 * kOneCode) << "a pixel out of range";
      ASSERT_EQ(form.whole(), value >> IntensityAcc::kFraction)
          << "pixel " << t << " of " << length;
      ASSERT_EQ(form.code(), surface.code()) << "pixel " << t << " of " << length;
    }
  }
};

// Segments of one pixel, or of any length on a line.
class ExactSegment : public QuadSegment {
 public:
  explicit ExactSegment(const ChannelSeed& seed) : QuadSegment(seed, Tolerance()) {}
};

using Forms = testing::Types<QuadSurface, QuadDifference, QuadThreeTerm, QuadThirdDifference,
                             QuadMidpoint, QuadStep, ExactSegment>;
TYPED_TEST_SUITE(QuadForms, Forms);

// 2A may be any number of ulps, or even: twice a rounded A.
TYPED_TEST(QuadForms, SamePixelsOnRandomSurfaces) {
  std::mt19937 random(1);
  for (int span = 0; span < 4000; ++span) {
    SCOPED_TRACE(span);
    const int length = RandomLength(random);
    const RealCurve curve = RandomCurve(random, length);
    this->ExpectSamePixels(span % 2 ? curve.SeedOfDifferences() : curve.SeedOfDifferenceAndA(),
                           length);
    if (this->HasFatalFailure()) return;
  }
}

TYPED_TEST(QuadForms, SamePixelsAtTheLimits) {
  const int64_t low = -86 * kOneCode, high = 341 * kOneCode;
  for (const bool up : {true, false}) {
    const int64_t first = up ? low : high, last = up ? high : low, way = last - first;
    this->ExpectSamePixels(Curve(first, last, -way), 2);
    this->ExpectSamePixels(Curve(first, last, -2 * way), 3);  // and back
    this->ExpectSamePixels(Curve(first, first, way), 3);      // stays, then jumps
    this->ExpectSamePixels(Curve(first, first + way / 4, way / 2), 3);
    this->ExpectSamePixels(Curve(first, first, 0), kMaxScreen);  // rests at the limit
  }
}

TYPED_TEST(QuadForms, WhatIsNotShownMayBeAnything) {
  std::mt19937 random(1);
  for (int i = 0; i < 100000; ++i) {
    const int64_t first = static_cast<int64_t>(random() % 427) * kOneCode - 86 * kOneCode;
    this->ExpectSamePixels(Curve(first, RandomAcc(random).raw(), RandomAcc(random).raw()), 1);
  }
}

// What span_setup and lane_seed make of a point, without their arithmetic.
ChannelSeed SeedAt(const SurfacePoint& point, int lane, int lanes) {
  const auto at = [&](int x) {
    return static_cast<int64_t>(PolynomialAt(point.surface, point.x + x, point.y));
  };
  return WrappedSeed(at(lane), at(lane + lanes), at(lane + lanes) - at(lane),
                     lanes * lanes * 2 * point.surface.a.raw());
}

// The forms that evaluate the surface anew show what the recurrences make of its seeds, whatever
// wraps on the way.
TEST(QuadSurfaceForms, SurfaceAndSeedsShowTheSamePixels) {
  std::mt19937 random(2);
  for (int span = 0; span < 4000; ++span) {
    const int length = RandomLength(random), lanes = random() % 2 ? 4 : 1;
    const int lane = static_cast<int>(random() % static_cast<unsigned>(lanes));
    const SurfacePoint point = RandomPoint(length, random);
    const ChannelSeed seed = SeedAt(point, lane, lanes);
    QuadPolynomial polynomial(point, lane, lanes);
    QuadHorner horner(point, lane, lanes);
    QuadStep step(seed);
    QuadDifference difference(seed);
    QuadSurface surface(seed);
    ExactSegment segment(seed);
    for (int t = lane; t < length; t += lanes) {
      SCOPED_TRACE(t);
      ASSERT_EQ(horner.whole(), polynomial.whole());
      ASSERT_EQ(step.whole(), polynomial.whole());
      ASSERT_EQ(difference.whole(), polynomial.whole());
      ASSERT_EQ(surface.whole(), polynomial.whole());
      ASSERT_EQ(segment.whole(), polynomial.whole());
      polynomial.Step();
      horner.Step();
      step.Step();
      difference.Step();
      surface.Step();
      segment.Step();
    }
  }
}

}  // namespace
}  // namespace shading
