// SPDX-License-Identifier: Apache-2.0
#include "model/choice/method_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "tb/dut/method_choice_dut.h"
#include "tests/accuracy/choice_triangle.h"
#include "tests/unit/choice/choice_stimulus.h"

namespace shading {
namespace {

using accuracy::ChoiceCase;
using accuracy::ChoicePoint;
using accuracy::ChoiceRegion;
using accuracy::ChoiceSearch;
using accuracy::ChoiceTriangle;
using accuracy::NeighborOf;
using accuracy::PlainMaterial;
using accuracy::RandomMaterial;
using accuracy::WithShininess;
using accuracy::WorstShare;

std::string Text(const Choice& c) {
  return std::string(Name(c.method)) + (c.dark ? " dark" : "") + (c.ambient ? " ambient" : "") +
         " channels " + std::to_string(c.channels);
}

TEST(MethodChoice, RtlMatchesModel) {
  std::mt19937 random(1);
  tb::MethodChoiceDut rtl;
  std::map<Method, int> seen;
  for (int i = 0; i < 1000000; ++i) {
    const LightRange range = AnyRange(random);
    const ChoiceLimit limit = AnyLimit(random);
    const Lighting lighting = random() % 2 == 0 ? Lighting::kBlinn : Lighting::kPhong;
    const Choice expected = MethodChoice::Of(range, limit, lighting);
    const Choice actual = rtl.Of(range, limit, lighting);
    ASSERT_EQ(actual, expected) << "input " << i << ": " << Text(actual) << ", model "
                                << Text(expected);
    ++seen[expected.method];
  }
  EXPECT_EQ(seen.size(), 6u);
  for (const auto& [method, count] : seen) EXPECT_GT(count, 1000) << Name(method);
}

// The same with ranges and limits of triangles and materials, where every method has its turn.
TEST(MethodChoice, RtlMatchesModelOnTriangles) {
  std::mt19937 random(2);
  ChoiceSearch search(3);
  tb::MethodChoiceDut rtl;
  std::map<Method, int> seen;
  for (int i = 0; i < 100000; ++i) {
    ChoiceRegion region;
    region.least_chord = 0.001;
    region.most_chord = i % 8 == 0 ? 1.7 : 1;
    region.reflected = random() % 2 == 0;
    region.highlight = static_cast<double>(random() % 12);
    const Lighting lighting = region.reflected ? Lighting::kPhong : Lighting::kBlinn;
    const ChoiceTriangle triangle(search.Start(region), lighting);
    const ChoiceLimit limit =
        MethodChoice::LimitOf(WithShininess(RandomMaterial(random), triangle.shininess()),
                              Tolerance::Round(0.25 * std::exp2(random() % 6)));
    const Choice expected = MethodChoice::Of(triangle.range(), limit, lighting);
    ASSERT_EQ(rtl.Of(triangle.range(), limit, lighting), expected) << "triangle " << i;
    ++seen[expected.method];
  }
  EXPECT_EQ(seen.size(), 6u);
}

// Without a clock the output belongs to the input of the same cycle.
TEST(MethodChoice, ContractMatchesRtl) {
  EXPECT_EQ(tb::MethodChoiceDut::kLatency, MethodChoice::kContract.latency_cycles);
  EXPECT_EQ(MethodChoice::kContract.interval_cycles, 1);
}

// Every method at every tolerance: what it does is within the tolerance, half of it on edges, and
// not so little that the bounds could not fail.
TEST(MethodChoice, ModelWithinErrorBound) {
  for (const Lighting lighting : {Lighting::kBlinn, Lighting::kPhong}) {
    std::map<Method, double> most;
    for (const Method method : {Method::kFlat, Method::kGouraud, Method::kQuad, Method::kQuadCosine,
                                Method::kPhongSurface, Method::kPhongDuff}) {
      for (const double tolerance : {0.5, 1.0, 2.0, 4.0}) {
        for (const bool edge : {false, true}) {
          const double share = WorstShare(method, lighting, tolerance, edge, 25);
          EXPECT_LE(share, 1) << Name(method) << " T " << tolerance << " edge " << edge;
          most[method] = std::max(most[method], share);
        }
      }
    }
    for (const auto& [method, share] : most) {
      RecordProperty(std::string(Name(method)), std::to_string(share));
      std::printf("%s %-16s %.3f of the tolerance\n",
                  lighting == Lighting::kBlinn ? "Blinn" : "Phong", Name(method).data(), share);
      // The exact ones take only what dropped highlights take.
      if (method != Method::kPhongSurface && method != Method::kPhongDuff) {
        EXPECT_GT(share, 0.5) << Name(method);
      }
    }
  }
}

// Neighbours of one material that share an edge show the same there within the tolerance, whatever
// was chosen for either.
TEST(MethodChoice, NeighborsAgreeOnSharedEdges) {
  std::mt19937 random(11);
  ChoiceSearch search(12);
  int differ = 0;
  for (int i = 0; i < 100000; ++i) {
    ChoiceRegion region;
    region.least_chord = 0.002;
    region.edge = true;
    region.reflected = random() % 2 == 0;
    region.highlight = static_cast<double>(random() % 10);
    const Lighting lighting = region.reflected ? Lighting::kPhong : Lighting::kBlinn;
    const double tolerance = std::array{0.5, 1.0, 2.0, 4.0}[random() % 4];
    const ChoicePoint point = search.Start(region);
    const ChoiceCase left = point.Case();
    const ChoiceTriangle one(left, point.shininess, lighting);
    const ChoiceTriangle other(NeighborOf(left, random), point.shininess, lighting);
    const Material material = WithShininess(RandomMaterial(random), one.shininess());
    const ChoiceLimit limit = MethodChoice::LimitOf(material, Tolerance::Round(tolerance));
    const Choice a = MethodChoice::Of(one.range(), limit, lighting);
    const Choice b = MethodChoice::Of(other.range(), limit, lighting);
    differ += a.method != b.method;
    ASSERT_LE(std::abs(one.Shown(a, material) - other.Shown(b, material)), tolerance)
        << Text(a) << " beside " << Text(b);
  }
  EXPECT_GT(differ, 10000);
}

// The highlight never passes what the choice takes for its maximum on the triangle.
TEST(MethodChoice, SpecularRangeHoldsOnTheWholeTriangle) {
  ChoiceSearch search(21);
  for (const bool reflected : {false, true}) {
    const Lighting lighting = reflected ? Lighting::kPhong : Lighting::kBlinn;
    for (int i = 0; i < 30000; ++i) {
      ChoiceRegion region;
      region.reflected = reflected;
      region.highlight = i % 10;
      const ChoiceTriangle triangle(search.Start(region), lighting);
      const double cosine = triangle.SpecularCosine();
      const LightRange range = triangle.range();
      const double turn = range.turn.ToReal();
      const double high = range.specular_high.ToReal();
      const double most = reflected || high < 0 ? high : high / std::sqrt(1 - turn / 3);
      ASSERT_LE(cosine, most + 1e-6) << "triangle " << i;
      if (!reflected) continue;
      ASSERT_GE(cosine, range.specular_low.ToReal() - 1e-6) << "triangle " << i;
    }
  }
}

TEST(MethodChoice, LogAddIsAnUpperBound) {
  for (int a = -400; a <= 100; a += 7) {
    for (int b = -400; b <= 100; ++b) {
      const double exact = 32 * std::log2(std::exp2(a / 32.0) + std::exp2(b / 32.0));
      EXPECT_GE(MethodChoice::LogAdd(a, b), exact - 32 * std::log2(1 + 1.0 / 250));
      EXPECT_LE(MethodChoice::LogAdd(a, b), exact + 6);
    }
  }
}

LightRange Range(double turn, double low, double high, double specular_low, double specular_high) {
  return {Turn::Round(turn), RangeCosine::Round(low), RangeCosine::Round(high),
          RangeCosine::Round(specular_low), RangeCosine::Round(specular_high)};
}

TEST(MethodChoice, EqualNormalsAreFlat) {
  const ChoiceLimit limit =
      MethodChoice::LimitOf(PlainMaterial(0.1, 0.5, 0.4, 32), Tolerance::Round(0.5));
  for (const Lighting lighting : {Lighting::kBlinn, Lighting::kPhong}) {
    EXPECT_EQ(MethodChoice::Of(Range(0, 0.9, 0.9, 1, 1), limit, lighting).method, Method::kFlat);
  }
  EXPECT_NE(MethodChoice::Of(Range(0.01, 0.9, 1, 0.9, 1), limit, Lighting::kBlinn).method,
            Method::kFlat);
}

TEST(MethodChoice, UnlitTrianglesAreAmbientHoweverFarTheyTurn) {
  const ChoiceLimit limit =
      MethodChoice::LimitOf(PlainMaterial(0.1, 0.5, 0.4, 32), Tolerance::Round(0.5));
  for (const double turn : {0.1, 1.0, 2.5}) {
    const Choice choice = MethodChoice::Of(Range(turn, -0.9, 0, -0.5, 0), limit, Lighting::kBlinn);
    EXPECT_EQ(choice.method, Method::kFlat);
    EXPECT_TRUE(choice.dark && choice.ambient);
  }
  const Choice lit = MethodChoice::Of(Range(0.1, -0.9, 0.001, -0.5, 0), limit, Lighting::kBlinn);
  EXPECT_TRUE(lit.dark && !lit.ambient);
  const Choice shiny = MethodChoice::Of(Range(0.1, -0.9, 0, 0.9, 1), limit, Lighting::kBlinn);
  EXPECT_FALSE(shiny.dark || shiny.ambient);
}

// 16 steps of the tolerance: what is dropped never reaches half a code nor T / 8.
TEST(MethodChoice, DroppedHighlightsDoNotShow) {
  for (double tolerance = 0.25; tolerance < 16; tolerance *= 1.25) {
    const ChoiceLimit limit =
        MethodChoice::LimitOf(PlainMaterial(0.1, 0.5, 0.4, 32), Tolerance::Round(tolerance));
    double brightest = 0;
    for (double cosine = 0.7; cosine < 1; cosine += 1e-4) {
      const LightRange range = Range(1e-6, 0.5, 0.6, cosine, cosine);
      if (!MethodChoice::Of(range, limit, Lighting::kBlinn).dark) break;
      brightest = 255 * 0.4 * std::pow(cosine, 32);
    }
    EXPECT_LT(brightest, std::min(0.5, tolerance / 8)) << tolerance;
    EXPECT_GT(brightest, std::min(0.5, tolerance / 8) / 4) << tolerance;
  }
}

TEST(MethodChoice, TerminatorAndFullScaleKeepGouraudAndQuadAway) {
  const Material faint = PlainMaterial(0.1, 0.5, 0.4, 32);
  const Material bright = PlainMaterial(0.3, 0.5, 0.4, 32);
  const auto method = [](double low, double high, const Material& material) {
    return MethodChoice::Of(Range(0.002, low, high, 0.95, 1),
                            MethodChoice::LimitOf(material, Tolerance::Round(1)), Lighting::kBlinn)
        .method;
  };
  EXPECT_EQ(method(0.5, 0.55, faint), Method::kQuad);
  EXPECT_EQ(method(0.5, 0.55, bright), Method::kQuadCosine);
  EXPECT_EQ(method(-0.02, 0.02, faint), Method::kQuadCosine);
}

TEST(MethodChoice, ChannelsThatAreNotBlack) {
  Material material = PlainMaterial(0, 0, 0, 8);
  material.ambient[0] = Reflectance::FromRaw(1);
  material.specular[2] = Reflectance::FromRaw(1);
  EXPECT_EQ(MethodChoice::LimitOf(material, Tolerance::Round(1)).channels, 5);
}

}  // namespace
}  // namespace shading
