// SPDX-License-Identifier: Apache-2.0
//
// Methods that interpolate normals against their closed forms, pixel by pixel before the code is
// rounded. The full search is accuracy_table's; this one takes fewer restarts.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>

#include "model/light/dot_product.h"
#include "model/normal/normal_setup.h"
#include "model/normal/slerp_direct.h"
#include "model/normal/slerp_direct_setup.h"
#include "model/normal/slerp_recurrence.h"
#include "model/normal/span_normals.h"
#include "tests/accuracy/worst_search.h"

namespace shading::accuracy {

void PrintTo(const Configuration& configuration, std::ostream* out) {
  *out << NameOf(configuration);
}

namespace {

constexpr double kLimit = 0.5;  // LSB
constexpr Effort kEffort = {5, 4, 14};
constexpr Effort kFlatEffort = {2, 4, 14};  // for methods whose error hardly varies
constexpr double kPi = 3.14159265358979323846;

double Worst(const Configuration& configuration, Ideal ideal, int length, double degrees, int n) {
  const Cell cell = {configuration, ideal, length, kLeastPart * degrees, degrees, n};
  return WorstSearch(cell).Run(kEffort).lsb;
}

// The cell of every length, angle and shininess, and for every length one of any angle.
template <typename Check>
void ForEachCell(const Configuration& configuration, Ideal ideal, const Check& check) {
  for (const int length : kLengths) {
    for (const int n : kShininess) {
      for (const double degrees : kAngles) {
        check({configuration, ideal, length, kLeastPart * degrees, degrees, n});
      }
      check({configuration, ideal, length, kAngles.front(), kAngles.back(), n});
    }
  }
}

std::string NameOf(const Cell& cell) {
  return NameOf(cell.configuration) + ", " + std::to_string(cell.length) + " pixels, " +
         std::to_string(cell.degrees) + " degrees, n = " + std::to_string(cell.shininess);
}

double Ulps(const UnitContract& unit, int bits) { return std::ldexp(unit.max_error_ulp, -bits); }

// What the contracts of the units on the way allow a component of the normal, or a cosine.
double QuantityBound(const Configuration& configuration) {
  const double ends = Ulps(NormalSetup::kContract, 30) + Ulps(SpanNormals::kContract, 30);
  if (configuration.method == Method::kSlerpDirect) {
    return ends + Ulps(SlerpDirectSetup::kContract, 30) + Ulps(SlerpDirect::kContract, 24);
  }
  // Four lanes take a quarter of the steps: t^2 / 4096 ulp and 1 more.
  const double recurrence = configuration.lanes == 1
                                ? Ulps(SlerpRecurrence::kContract, 28)
                                : Ulps(SlerpRecurrence::kContract, 32) + std::ldexp(1, -28);
  const bool vectors = configuration.method == Method::kSlerp;
  return ends + recurrence + std::ldexp(1, vectors ? -25 : -31);
}

// In LSB: d(x^n) <= n dx.
double ContractBound(const Cell& cell) {
  const double quantity = QuantityBound(cell.configuration);
  const double cosine = cell.configuration.method == Method::kSlerpIntensity
                            ? quantity
                            : std::sqrt(3.0) * quantity + Ulps(DotProduct::kContract, 30);
  const double light =
      cell.shininess == 1 ? std::ldexp(1, -18) : Ulps(BlinnSpecular::kContract, 16);
  return 255 * (cell.shininess * cosine + light);
}

class SlerpAccuracy : public testing::TestWithParam<Configuration> {};

TEST_P(SlerpAccuracy, WithinHalfACodeAndWithinTheContracts) {
  double worst = 0;
  ForEachCell(GetParam(), Ideal::kSlerp, [&](const Cell& cell) {
    const double lsb = WorstSearch(cell).Run(kEffort).lsb;
    EXPECT_LE(lsb, kLimit) << NameOf(cell);
    EXPECT_LE(lsb, ContractBound(cell)) << NameOf(cell);
    if (cell.shininess <= 128) worst = std::max(worst, lsb);
  });
  RecordProperty("worst_lsb_to_128", std::to_string(worst));
}

INSTANTIATE_TEST_SUITE_P(All, SlerpAccuracy,
                         testing::Values(Configuration{Method::kSlerp, 1},
                                         Configuration{Method::kSlerp, 4},
                                         Configuration{Method::kSlerpIntensity, 1},
                                         Configuration{Method::kSlerpIntensity, 4},
                                         Configuration{Method::kSlerpDirect, 1},
                                         Configuration{Method::kSlerpDirect, 4}),
                         [](const auto& test) {
                           const Method method = test.param.method;
                           const std::string name = method == Method::kSlerp         ? "Normals"
                                                    : method == Method::kSlerpDirect ? "Direct"
                                                                                     : "Cosines";
                           return name + std::to_string(test.param.lanes);
                         });

TEST(PhongAccuracy, DirectIsClassicPhongWithinHalfACode) {
  ForEachCell({Method::kPhong}, Ideal::kPhong, [](const Cell& cell) {
    EXPECT_LE(WorstSearch(cell).Run(kFlatEffort).lsb, kLimit) << NameOf(cell);
  });
}

// Long spans of short normals lose |N|^2: docs/units/normal/duff_normalizer.md.
TEST(PhongAccuracy, DuffIsClassicPhongWithinHalfACodeUpTo170Degrees) {
  ForEachCell({Method::kPhongDuff}, Ideal::kPhong, [](Cell cell) {
    if (cell.length > 256) cell.degrees = std::min(cell.degrees, 170.0);
    cell.least_degrees = std::min(cell.least_degrees, cell.degrees * kLeastPart);
    EXPECT_LE(WorstSearch(cell).Run(kFlatEffort).lsb, kLimit) << NameOf(cell);
  });
  EXPECT_GT(Worst({Method::kPhongDuff}, Ideal::kPhong, 2048, 179, 128), kLimit);
}

TEST(PhongAccuracy, TaylorFailsOnWideArcs) {
  const auto taylor = [](double degrees, int n) {
    return Worst({Method::kPhongTaylor}, Ideal::kPhong, 256, degrees, n);
  };
  EXPECT_LE(taylor(45, 1), kLimit);
  EXPECT_LE(taylor(20, 128), kLimit);
  EXPECT_GT(taylor(55, 1), kLimit);
  EXPECT_GT(taylor(30, 128), kLimit);
  // In the middle q = cos(psi / 2)^2, and the light stands there.
  const Real q = std::pow(std::cos(kPi / 6), 2), x = q - 1;
  const Real lost = 1 - std::sqrt(q) * (1 - x / 2 + 3 * x * x / 8);
  EXPECT_NEAR(taylor(60, 1), static_cast<double>(255 * lost), 0.05);
}

TEST(SlerpPaperAccuracy, SixteenBitsFail) {
  const auto paper = [](int bits, int length, double degrees, int n) {
    return Worst({Method::kSlerpPaper, 1, bits}, Ideal::kSlerp, length, degrees, n);
  };
  EXPECT_LE(paper(16, 16, 30, 1), kLimit);
  EXPECT_GT(paper(16, 16, 30, 128), kLimit);
  EXPECT_GT(paper(16, 64, 30, 1), 2);
  EXPECT_GT(paper(16, 256, 30, 1), 20);
  EXPECT_GT(paper(16, 2048, 90, 1), 100);
  EXPECT_GT(paper(24, 2048, 30, 1), kLimit);
  EXPECT_LE(paper(30, 2048, 30, 1), kLimit);
  EXPECT_GT(paper(30, 2048, 30, 128), kLimit);
  EXPECT_LE(paper(38, 2048, 30, 128), kLimit);
}

TEST(Pictures, SlerpAndPhongDifferBeyondThirtyDegrees) {
  const auto difference = [](double degrees, int n) {
    return Worst({Method::kSlerp}, Ideal::kPhong, 256, degrees, n);
  };
  EXPECT_LE(difference(28, 1), kLimit);
  EXPECT_LE(difference(14.5, 128), kLimit);
  EXPECT_GT(difference(29, 1), kLimit);
  EXPECT_GT(difference(90, 1), 15);
  EXPECT_GT(difference(90, 128), 100);
}

// What the page says of lanes: exact recurrences do not feel them.
TEST(PhongAccuracy, FourLanesChangeNothing) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  std::vector<LightCosines> one, four;
  for (int i = 0; i < 200; ++i) {
    SpanCase span;
    span.length = 1 + static_cast<int>(random() % 2048);
    const auto draw = [&] { return Unit({uniform(random), uniform(random), uniform(random)}); };
    const std::array<Direction, 3> drawn = {draw(), draw(), draw()};
    for (size_t c = 0; c < 3; ++c) {
      span.normal[0][c] = SpanNormalComponent::Round(static_cast<double>(drawn[0][c]));
      span.normal[1][c] = SpanNormalComponent::Round(static_cast<double>(drawn[1][c]));
      span.direction[c] = NormalComponent::Round(static_cast<double>(drawn[2][c]));
    }
    for (const Method method : {Method::kPhong, Method::kPhongTaylor, Method::kPhongDuff}) {
      ModelCosines({method, 1}, span, &one);
      ModelCosines({method, kMaxLanes}, span, &four);
      for (size_t t = 0; t < one.size(); ++t) {
        ASSERT_EQ(one[t].n_dot_l, four[t].n_dot_l) << Name(method) << " pixel " << t;
        ASSERT_EQ(one[t].n_dot_h_or_v, four[t].n_dot_h_or_v) << Name(method) << " pixel " << t;
      }
    }
  }
}

// The ideals about the middle of the arc against the forms from its ends.
TEST(IdealSpan, EqualsThePapersFormulaAndTheNormalisedLine) {
  constexpr int kLength = 100;
  const std::array<SpanNormal, 2> ends = {
      SpanNormal{SpanNormalComponent::Round(0.6), SpanNormalComponent::Round(0),
                 SpanNormalComponent::Round(0.8)},
      SpanNormal{SpanNormalComponent::Round(-0.6), SpanNormalComponent::Round(0.64),
                 SpanNormalComponent::Round(0.48)}};
  const Vector3 direction = {NormalComponent::Round(0.36), NormalComponent::Round(0.48),
                             NormalComponent::Round(0.8)};
  const Direction a = Unit(ToReal(ends[0])), b = Unit(ToReal(ends[1])), d = ToReal(direction);
  const Real psi = std::acos(Dot(a, b));
  IdealSpan slerp, phong;
  slerp.Set(Ideal::kSlerp, ends, kLength);
  phong.Set(Ideal::kPhong, ends, kLength);
  for (size_t t = 0; t < kLength; ++t) {
    const Real w = static_cast<Real>(t) / (kLength - 1);
    const Direction arc = Combination(std::sin((1 - w) * psi) / std::sin(psi), a,
                                      std::sin(w * psi) / std::sin(psi), b);
    EXPECT_NEAR(static_cast<double>(slerp.Cosines(direction).At(t) - Dot(arc, d)), 0, 1e-17);
    const Direction line = Unit(Combination(1 - w, ToReal(ends[0]), w, ToReal(ends[1])));
    EXPECT_NEAR(static_cast<double>(phong.Cosines(direction).At(t) - Dot(line, d)), 0, 1e-17);
  }
}

}  // namespace
}  // namespace shading::accuracy
