// SPDX-License-Identifier: Apache-2.0
//
// The rule against the errors that a search finds, for single materials and mixed ones.
#include "model/raster/turn_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/accuracy/spread_search.h"

namespace shading {
namespace {

using accuracy::SearchedError;
using accuracy::SpreadLight;

constexpr accuracy::SpreadEffort kEffort = {12, 20, 250};
constexpr double kTolerances[] = {0.5, 1, 2, 4};

Material MaterialOf(const SpreadLight& light) {
  Material material;
  material.diffuse.fill(Reflectance::Round(light.diffuse));
  material.specular.fill(Reflectance::Round(light.specular));
  material.shininess = Shininess::FromRaw(int64_t{light.shininess} << Shininess::kFraction);
  return material;
}

class TurnLimitOf : public testing::TestWithParam<Method> {
 protected:
  // Within the tolerance at the angle, and beyond it at 1 / 0.7 of the angle.
  static void ExpectSafeAndUseful(const SpreadLight& light, double tolerance) {
    const Method method = GetParam();
    const double angle = TurnLimitDegrees(method, MaterialOf(light), tolerance);
    const auto where = testing::Message()
                       << "kd " << light.diffuse << " ks " << light.specular << " n "
                       << light.shininess << " T " << tolerance << " angle " << angle;
    EXPECT_LE(SearchedError(method, light, angle, kEffort), tolerance) << where;
    EXPECT_GT(SearchedError(method, light, std::min(angle / 0.7, 120.0), kEffort), tolerance)
        << where;
  }
};

TEST_P(TurnLimitOf, IsSafeAndNotNeedlesslySmall) {
  for (const double kd : {0.0, 0.5, 1.0}) {
    for (const double ks : {0.0, 0.5, 1.0}) {
      for (const int n : {1, 8, 32, 128, 256}) {
        if (kd + ks == 0 || (ks == 0 && n > 1)) continue;
        for (const double tolerance : kTolerances) {
          ExpectSafeAndUseful({kd, ks, n, true}, tolerance);
        }
      }
    }
  }
}

// Between the shininesses that the rules are made of, and faint light, where the angle is large.
TEST_P(TurnLimitOf, IsSafeBetweenAndForFaintLight) {
  for (const int n : {2, 3, 4, 5, 16, 64, 180}) {
    for (const double tolerance : kTolerances) ExpectSafeAndUseful({0, 1, n, true}, tolerance);
  }
  for (const int n : {1, 2, 8, 128, 256}) {
    for (const double tolerance : kTolerances) {
      const SpreadLight light = {1.0 / 32, 1.0 / 16, n, true};
      const double angle = TurnLimitDegrees(GetParam(), MaterialOf(light), tolerance);
      EXPECT_LE(SearchedError(GetParam(), light, angle, kEffort), tolerance)
          << "n " << n << " T " << tolerance << " angle " << angle;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, TurnLimitOf,
                         testing::Values(Method::kGouraud, Method::kQuad, Method::kQuadSplit,
                                         Method::kQuadCosine),
                         [](const auto& test) {
                           std::string name(Name(test.param));
                           for (char& c : name) c = c == '-' ? '_' : c;
                           return name;
                         });

TEST(TurnLimit, HoldsAcrossTheTerminatorForMethodsThatClampPerPixel) {
  for (const Method method : {Method::kQuadSplit, Method::kQuadCosine}) {
    for (const SpreadLight& light : {SpreadLight{1, 0, 1, false},
                                     {0.5, 0.5, 8, false},
                                     {1, 0.5, 32, false},
                                     {0.5, 0.5, 128, false}}) {
      for (const double tolerance : kTolerances) {
        const double angle = TurnLimitDegrees(method, MaterialOf(light), tolerance);
        EXPECT_LE(SearchedError(method, light, angle, kEffort), tolerance)
            << Name(method) << " n " << light.shininess << " T " << tolerance;
      }
    }
  }
}

TEST(TurnLimit, EveryFormOfQuadHasItsLimit) {
  const Material material = MaterialOf({0.5, 0.5, 32, true});
  for (const Method method : kAllMethods) {
    if (!IsQuadRow(method)) continue;
    EXPECT_EQ(TurnLimitDegrees(method, material, 1), TurnLimitDegrees(Method::kQuad, material, 1))
        << Name(method);
  }
}

TEST(TurnLimit, BlackMaterialsAndInterpolatedNormalsAreNeverSplit) {
  for (const Method method : kAllMethods) {
    EXPECT_EQ(TurnLimitDegrees(method, MaterialOf({0, 0, 128, true}), 0.5), 180) << Name(method);
    if (method == Method::kFlat || InterpolatesNormals(method)) {
      EXPECT_EQ(TurnLimitDegrees(method, MaterialOf({1, 1, 128, true}), 0.5),
                method == Method::kFootprintPaper ? 30 : 180)
          << Name(method);
    }
  }
}

TEST(TurnLimit, IsTheSquaredChord) {
  const Material material = MaterialOf({1, 0, 1, true});
  const double degrees = TurnLimitDegrees(Method::kGouraud, material, 1);
  const auto square = [](double angle) {
    const double chord = 2 * std::sin(angle * 3.14159265358979323846 / 360);
    return chord * chord;
  };
  const auto tolerance = Tolerance::FromRaw(int64_t{1} << Tolerance::kFraction);
  const double limit =
      std::ldexp(static_cast<double>(TurnLimit(Method::kGouraud, material, tolerance)), -44);
  EXPECT_LE(limit, square(degrees));
  EXPECT_GT(limit, square(degrees - 1.0 / 1024) - std::ldexp(1.0, -28));
}

}  // namespace
}  // namespace shading
