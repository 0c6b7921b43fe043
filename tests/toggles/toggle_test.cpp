// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tb/stimulus/random_triangles.h"
#include "tests/toggles/skip.h"
#include "tests/toggles/toggle_run.h"

namespace shading::test {
namespace {

// Flags without a reset, once at the start of a waveform.
constexpr int64_t kSettling = 8;

// Units that a method of intensities has no use for: the light, the normals, the cosines' surfaces.
const std::set<std::string> kLight = {"normal_setup",
                                      "n_dot_l_curve",
                                      "n_dot_h_or_v_curve",
                                      "linear_recurrence",
                                      "duff_cosines",
                                      "slerp_recurrence",
                                      "phong_direct",
                                      "duff_normalizer",
                                      "n_dot_l",
                                      "n_dot_h_or_v",
                                      "blinn_specular",
                                      "specular_cosine",
                                      "rgb_combine",
                                      "cosine_delay",
                                      "dots",
                                      "chord",
                                      "angle",
                                      "difference",
                                      "adaptive_normalizer",
                                      "slerp_direct"};

// Surfaces, one a method.
const std::set<std::string> kSurfaces = {
    "flat_color",    "gouraud_interpolator", "quad_surface",    "quad_step",
    "quad_midpoint", "quad_three_term",      "quad_difference", "quad_third_difference",
    "quad_segment",  "quad_split",           "quad_polynomial", "quad_horner"};

tb::Toggles TogglesOf(const TriangleList& list, Method method) {
  return tb::ByUnit(Trace(WorkOf(list, method)).signals);
}

int64_t Sum(const tb::Toggles& toggles, const std::set<std::string>& units) {
  int64_t sum = 0;
  for (const auto& [unit, count] : toggles) sum += units.count(unit) > 0 ? count.toggles : 0;
  return sum;
}

TEST(Toggles, UnitsOfTheLightHoldWhereIntensitiesAreInterpolated) {
  const TriangleList list = tb::RandomTriangles(3, 60);
  for (const Method method : {Method::kFlat, Method::kGouraud, Method::kQuad}) {
    const tb::Toggles toggles = TogglesOf(list, method);
    EXPECT_GT(toggles.at("pixel_walker").toggles, 0) << Name(method);
    for (const std::string& unit : kLight) {
      ASSERT_EQ(toggles.count(unit), 1U) << unit << ": no such instance";
      EXPECT_LE(toggles.at(unit).toggles, kSettling) << unit << " for " << Name(method);
    }
  }
}

TEST(Toggles, OnlyTheChosenSurfaceMoves) {
  const TriangleList list = tb::RandomTriangles(4, 60);
  for (const auto& [method, chosen] :
       {std::pair(Method::kGouraud, "gouraud_interpolator"),
        std::pair(Method::kQuad, "quad_surface"), std::pair(Method::kQuadStep, "quad_step")}) {
    const tb::Toggles toggles = TogglesOf(list, method);
    for (const std::string& unit : kSurfaces) {
      ASSERT_EQ(toggles.count(unit), 1U) << unit << ": no such instance";
      const int64_t changes = toggles.at(unit).toggles;
      EXPECT_EQ(changes > kSettling, unit == chosen) << unit << " for " << Name(method);
    }
  }
}

// Registers and operands of span_setup, by parts of their path.
void ExpectPathsHold(const std::vector<tb::SignalToggles>& signals,
                     const std::vector<std::string>& parts) {
  for (const std::string& part : parts) {
    int64_t count = 0;
    for (const tb::SignalToggles& signal : signals) {
      if (signal.path.find(part) == std::string::npos) continue;
      ++count;
      EXPECT_LE(signal.toggles, kSettling) << signal.path;
    }
    EXPECT_GT(count, 3) << part << ": names have changed";
  }
}

TEST(Toggles, SetUpOfOtherSurfacesHolds) {
  const TriangleList list = tb::RandomTriangles(8, 60);
  const std::vector<std::string> others = {"u_curve_rows.", "u_specular_row_start.",
                                           "u_point_rows."};
  for (const Method method : {Method::kFlat, Method::kGouraud, Method::kQuad}) {
    SCOPED_TRACE(Name(method));
    ExpectPathsHold(Trace(WorkOf(list, method)).signals, others);
  }
  const std::vector<std::string> channels = {"u_span_setup.gen_channel[0].gen_rows.u_row_start.",
                                             "u_specular_row_start.", "u_point_rows."};
  for (const Method method : {Method::kQuadCosine, Method::kPhongSurface}) {
    SCOPED_TRACE(Name(method));
    const auto signals = Trace(WorkOf(list, method)).signals;
    ExpectPathsHold(signals, channels);
    if (method == Method::kQuadCosine) ExpectPathsHold(signals, {"u_curve_rows.gen_curve[2]."});
  }
}

TEST(Toggles, NormalsHoldWherePhongIsSetUpByTriangle) {
  const tb::Toggles toggles = TogglesOf(tb::RandomTriangles(8, 60), Method::kPhongSurface);
  EXPECT_GT(toggles.at("duff_normalizer").toggles, kSettling);
  for (const char* unit :
       {"normal_setup", "linear_recurrence", "slerp_recurrence", "phong_direct"}) {
    EXPECT_LE(toggles.at(unit).toggles, kSettling) << unit;
  }
}

void ExpectHold(const tb::Toggles& toggles, const std::set<std::string>& units) {
  for (const std::string& unit : units) {
    ASSERT_EQ(toggles.count(unit), 1U) << unit << ": no such instance";
    EXPECT_LE(toggles.at(unit).toggles, kSettling) << unit;
  }
}

// Wires from the frame's light, which comes once.
bool IsOfFrame(const std::string& path) {
  return path.find("u_dots.gen_component") != std::string::npos &&
         (path.find("].light") != std::string::npos ||
          path.find("].half_or_view") != std::string::npos);
}

TEST(Toggles, LightAndOtherSurfacesHoldInAutoFramesOfOneColourATriangle) {
  TriangleList list = tb::RandomTriangles(6, 60);
  for (TrianglePacket& packet : list.triangles) packet.n[1] = packet.n[2] = packet.n[0];
  const FrameWork work = WorkOf(list, Method::kAuto);
  ASSERT_EQ(work.share[static_cast<size_t>(Method::kFlat)].pixels, work.pixels);
  std::vector<tb::SignalToggles> signals;
  for (tb::SignalToggles& signal : Trace(work).signals) {
    if (!IsOfFrame(signal.path)) signals.push_back(std::move(signal));
  }
  const tb::Toggles toggles = tb::ByUnit(signals);
  EXPECT_GT(toggles.at("flat_color").toggles, kSettling);
  std::set<std::string> rest = kSurfaces;
  rest.erase("flat_color");
  ExpectHold(toggles, rest);
  ExpectHold(toggles, kLight);
}

// The highlight's part of the lit pixels: the power, N.H and its way. Valid bits move, and wires
// from the set-up and from the materials.
bool IsOfHighlight(const std::string& path) {
  for (const char* part : {"u_blinn_specular.", "u_specular_cosine.", "u_n_dot_h_or_v_curve.",
                           "gen_quantity[1].", "u_cosine_delay.memory"}) {
    if (path.find(part) == std::string::npos) continue;
    for (const char* other : {"valid_q", "diffuse", "unlit", ".shininess", "_curve.seed.",
                              ".n_dot_l", "gen_paper.kappa"}) {
      if (path.find(other) != std::string::npos) return false;
    }
    return true;
  }
  return false;
}

void ExpectNoHighlight(const FrameWork& work, bool holds) {
  int64_t signals = 0, toggles = 0;
  for (const tb::SignalToggles& signal : Trace(work).signals) {
    if (!IsOfHighlight(signal.path)) continue;
    ++signals;
    toggles += signal.toggles;
    if (holds) {
      EXPECT_LE(signal.toggles, kSettling) << signal.path;
    }
  }
  EXPECT_GT(signals, 20) << "names have changed";
  if (!holds) {
    EXPECT_GT(toggles, work.pixels);
  }
}

TriangleList WithSpecular(TriangleList list, double specular) {
  for (Material& material : list.frame.materials) {
    material.specular.fill(Reflectance::Round(specular));
  }
  return list;
}

// 255 ks of 1/16 code is below what shows; ks = 0 is known to pixel_light, too.
TEST(Toggles, HighlightHoldsInAutoFramesWithoutOne) {
  const TriangleList list = tb::RandomTriangles(7, 60);
  for (const double specular : {0., 1. / 4096}) {
    const FrameWork work = WorkOf(WithSpecular(list, specular), Method::kAuto);
    for (const Method method :
         {Method::kQuadCosine, Method::kPhongSurface, Method::kPhongDuff}) {
      EXPECT_GT(work.share[static_cast<size_t>(method)].pixels, 0) << Name(method);
    }
    ExpectNoHighlight(work, true);
  }
  ExpectNoHighlight(WorkOf(WithSpecular(list, 0.5), Method::kAuto), false);
}

TEST(Toggles, HighlightHoldsForEveryMethodThatIsToldSo) {
  const TriangleList list = WithSpecular(tb::RandomTriangles(7, 60), 0.5);
  for (const Method method : {Method::kQuadCosine, Method::kPhongSurface, Method::kPhongDuff}) {
    SCOPED_TRACE(Name(method));
    for (const bool dark : {true, false}) {
      const auto choose = [&](const LightRange&, const ChoiceLimit&) {
        return Choice{method, dark, false, 7};
      };
      const FrameWork work = WorkWith(list, kOneCode, choose);
      ExpectNoHighlight(work, dark);
      if (dark) ExpectPathsHold(Trace(work).signals, {"u_curve_rows.gen_curve[1]."});
    }
  }
}

TEST(Toggles, LightMovesWhereItIsWanted) {
  const TriangleList list = tb::RandomTriangles(5, 60);
  EXPECT_GT(Sum(TogglesOf(list, Method::kPhongDuff), kLight), 0);
  EXPECT_GT(Sum(TogglesOf(list, Method::kAuto), kLight), 0);
}

}  // namespace
}  // namespace shading::test
