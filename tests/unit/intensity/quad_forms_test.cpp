// SPDX-License-Identifier: Apache-2.0
//
// Every exact form of paper 003 shows the same pixels: a surface that S9.26 represents has no error
// that could tell them apart.
#include <gtest/gtest.h>

#include <vector>

#include "model/intensity/quad_difference.h"
#include "model/intensity/quad_midpoint.h"
#include "model/intensity/quad_surface.h"
#include "model/intensity/quad_third_difference.h"
#include "model/intensity/quad_three_term.h"
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

using Forms =
    testing::Types<QuadSurface, QuadDifference, QuadThreeTerm, QuadThirdDifference, QuadMidpoint>;
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

}  // namespace
}  // namespace shading
