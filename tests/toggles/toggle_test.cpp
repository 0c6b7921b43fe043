// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

#include "tb/stimulus/random_triangles.h"
#include "tests/toggles/toggle_run.h"

namespace shading::test {
namespace {

// Flags without a reset, once at the start of a waveform.
constexpr int64_t kSettling = 8;
constexpr Tolerance kOneCode = Tolerance::FromRaw(int64_t{1} << Tolerance::kFraction);

// Units that a method of intensities has no use for: the light, the normals, the cosines' surfaces.
const std::set<std::string> kLight = {
    "normal_setup",      "n_dot_l_curve", "n_dot_h_or_v_curve", "linear_recurrence",
    "length_recurrence", "slerp_recurrence", "phong_direct",    "duff_normalizer",
    "n_dot_l",           "n_dot_h_or_v",  "blinn_specular",     "specular_cosine",
    "rgb_combine",       "cosine_delay",  "dots",               "chord",
    "angle",             "difference",    "adaptive_normalizer", "slerp_direct"};

int64_t Sum(const tb::Toggles& toggles, const std::set<std::string>& units) {
  int64_t sum = 0;
  for (const auto& [unit, count] : toggles) sum += units.count(unit) > 0 ? count.toggles : 0;
  return sum;
}

TEST(Toggles, UnitsOfTheLightHoldWhereIntensitiesAreInterpolated) {
  const TriangleList list = tb::RandomTriangles(3, 60);
  for (const Method method : {Method::kFlat, Method::kGouraud, Method::kQuad}) {
    const tb::Toggles toggles = TogglesOf(list, method, kOneCode);
    EXPECT_GT(toggles.at("pixel_walker").toggles, 0) << Name(method);
    for (const std::string& unit : kLight) {
      ASSERT_EQ(toggles.count(unit), 1U) << unit << ": no such instance";
      EXPECT_LE(toggles.at(unit).toggles, kSettling) << unit << " for " << Name(method);
    }
  }
}

TEST(Toggles, OnlyTheChosenSurfaceMoves) {
  const std::set<std::string> kSurfaces = {
      "flat_color",    "gouraud_interpolator", "quad_surface",    "quad_step",
      "quad_midpoint", "quad_three_term",      "quad_difference", "quad_third_difference",
      "quad_segment",  "quad_split",           "quad_polynomial", "quad_horner"};
  const TriangleList list = tb::RandomTriangles(4, 60);
  for (const auto& [method, chosen] :
       {std::pair(Method::kGouraud, "gouraud_interpolator"),
        std::pair(Method::kQuad, "quad_surface"), std::pair(Method::kQuadStep, "quad_step")}) {
    const tb::Toggles toggles = TogglesOf(list, method, kOneCode);
    for (const std::string& unit : kSurfaces) {
      ASSERT_EQ(toggles.count(unit), 1U) << unit << ": no such instance";
      const int64_t changes = toggles.at(unit).toggles;
      EXPECT_EQ(changes > kSettling, unit == chosen) << unit << " for " << Name(method);
    }
  }
}

TEST(Toggles, LightMovesWhereItIsWanted) {
  const TriangleList list = tb::RandomTriangles(5, 60);
  EXPECT_GT(Sum(TogglesOf(list, Method::kPhongDuff, kOneCode), kLight), 0);
  EXPECT_GT(Sum(TogglesOf(list, Method::kAuto, kOneCode), kLight), 0);
}

}  // namespace
}  // namespace shading::test
