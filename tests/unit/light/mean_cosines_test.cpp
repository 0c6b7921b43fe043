// SPDX-License-Identifier: Apache-2.0
#include "model/light/mean_cosines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/ideal/lighting.h"
#include "tests/unit/light/normal_stimulus.h"

namespace shading {
namespace {

const Vector3 kX = Quantised(1, 0, 0), kY = Quantised(0, 1, 0), kMinusX = Quantised(-1, 0, 0);

template <size_t N>
std::array<LightCosines, N> CosinesOf(const std::array<Vector3, N>& normals, const Vector3& light,
                                       const Vector3& half) {
  std::array<LightCosines, N> cosines;
  for (size_t i = 0; i < N; ++i) {
    cosines[i] = {CosineOf(normals[i], light), CosineOf(normals[i], half)};
  }
  return cosines;
}

template <size_t N>
ideal::Vector SumOf(const std::array<Vector3, N>& normals) {
  ideal::Vector sum = {};
  for (const Vector3& normal : normals) sum = ideal::Sum(sum, ideal::ToReal(normal));
  return sum;
}

double Ulps(Cosine actual, double ideal) {
  return std::abs(std::ldexp(actual.ToReal() - ideal, Cosine::kFraction));
}

struct Worst {
  double error = 0;     // ulp, |sum| >= 1
  double fraction = 0;  // error divided by its bound, any |sum|
  int undefined = 0;

  template <size_t N>
  void Try(const std::array<Vector3, N>& normals, const Vector3& light, const Vector3& half) {
    const ideal::Vector sum = SumOf(normals);
    const double length = std::sqrt(ideal::Dot(sum, sum));
    const auto mean = MeanCosines::Of(normals, CosinesOf(normals, light, half));
    ASSERT_EQ(mean.has_value(), length * length >= 1.0 / 1024);
    if (!mean) {
      ++undefined;
      return;
    }
    const double now =
        std::max(Ulps(mean->n_dot_l, ideal::Dot(sum, ideal::ToReal(light)) / length),
                 Ulps(mean->n_dot_h_or_v, ideal::Dot(sum, ideal::ToReal(half)) / length));
    if (length >= 1) error = std::max(error, now);
    fraction = std::max(fraction, now / (2 / length + 0.5));
  }
};

TEST(MeanCosines, ModelWithinErrorBound) {
  std::mt19937 random(1);
  Worst edge, face;
  for (int i = 0; i < 500000; ++i) {
    const Vector3 light = RandomNormal(random), half = Near(light, 0.5, random);
    const Vector3 a = Near(light, std::ldexp(2, -static_cast<int>(random() % 8)), random);
    const Vector3 opposite = {NormalComponent::FromRaw(-a[0].raw()),
                              NormalComponent::FromRaw(-a[1].raw()),
                              NormalComponent::FromRaw(-a[2].raw())};
    const double spread = std::ldexp(1, -static_cast<int>(random() % 12));
    const Vector3 b = Near(random() % 4 ? a : opposite, spread, random);
    edge.Try(std::array<Vector3, 2>{a, b}, light, half);
    face.Try(std::array<Vector3, 3>{a, b, Near(a, spread, random)}, light, half);
  }
  RecordProperty("worst_edge_milliulp", static_cast<int>(edge.error * 1000));
  RecordProperty("worst_face_milliulp", static_cast<int>(face.error * 1000));
  RecordProperty("worst_permille_of_bound", static_cast<int>(edge.fraction * 1000));
  EXPECT_LT(std::max(edge.error, face.error), MeanCosines::kContract.max_error_ulp);
  EXPECT_LE(std::max(edge.fraction, face.fraction), 1);
  EXPECT_GT(edge.error, 0.5) << "the search is blind: rounding alone costs half an ulp";
  EXPECT_GT(edge.undefined, 0);
}

TEST(MeanCosines, RightAngleBisectsExactly) {
  const std::array<Vector3, 2> normals = {kX, kY};
  const auto mean = MeanCosines::Of(normals, CosinesOf(normals, kX, kY));
  ASSERT_TRUE(mean);
  EXPECT_EQ(mean->n_dot_l, Cosine::Round(std::sqrt(0.5)));
  EXPECT_EQ(mean->n_dot_h_or_v, Cosine::Round(std::sqrt(0.5)));
}

TEST(MeanCosines, EqualNormalsKeepTheirCosines) {
  const std::array<Vector3, 2> edge = {kX, kX};
  const std::array<Vector3, 3> face = {kX, kX, kX};
  const Vector3 light = Quantised(1, 2, 3);
  EXPECT_EQ(MeanCosines::Of(edge, CosinesOf(edge, light, kX))->n_dot_l, CosineOf(kX, light));
  EXPECT_EQ(MeanCosines::Of(face, CosinesOf(face, light, kX))->n_dot_l, CosineOf(kX, light));
}

TEST(MeanCosines, NegativeCosinesMirrorPositive) {
  const std::array<Vector3, 2> normals = {kX, kY};
  const Vector3 light = Quantised(3, 2, 1), away = Quantised(-3, -2, -1);
  const auto mean = MeanCosines::Of(normals, CosinesOf(normals, light, away));
  EXPECT_EQ(mean->n_dot_l.raw(), -mean->n_dot_h_or_v.raw());
}

TEST(MeanCosines, UndefinedExactlyBelowLimit) {
  Vector3 almost = kMinusX;
  almost[1] = NormalComponent::FromRaw(int64_t{1} << 17);  // sum (0, 2^-5, 0)
  std::array<Vector3, 2> normals = {kX, almost};
  EXPECT_TRUE(MeanCosines::Of(normals, CosinesOf(normals, kX, kY)));
  normals[1][1] = NormalComponent::FromRaw((int64_t{1} << 17) - 1);
  EXPECT_FALSE(MeanCosines::Of(normals, CosinesOf(normals, kX, kY)));
}

TEST(MeanCosines, UndefinedFaceTakesFirstVertex) {
  const double s = std::sqrt(0.75);
  const std::array<Vector3, 3> normals = {kX, Quantised(-0.5, s, 0), Quantised(-0.5, -s, 0)};
  const auto cosines = CosinesOf(normals, Quantised(2, 1, 0), kX);
  EXPECT_FALSE(MeanCosines::Of(normals, cosines));
  EXPECT_EQ(MeanCosines::OfFace(normals, cosines).n_dot_l, cosines[0].n_dot_l);
  EXPECT_EQ(MeanCosines::OfFace(normals, cosines).n_dot_h_or_v, cosines[0].n_dot_h_or_v);
}

TEST(MeanCosines, ForeignCosinesSaturate) {
  Vector3 almost = kMinusX;
  almost[1] = NormalComponent::FromRaw(int64_t{1} << 17);
  const LightCosines high = {Cosine::FromRaw((int64_t{1} << 31) - 1),
                              Cosine::FromRaw(-(int64_t{1} << 31))};
  const auto mean = MeanCosines::Of<2>({kX, almost}, {high, high});
  EXPECT_EQ(mean->n_dot_l.raw(), (int64_t{1} << 31) - 1);
  EXPECT_EQ(mean->n_dot_h_or_v.raw(), -(int64_t{1} << 31));
}

TEST(MeanCosines, WidestVectorsDoNotOverflow) {
  const NormalComponent least = NormalComponent::FromRaw(-(int64_t{1} << 23));
  const Vector3 corner = {least, least, least};
  const LightCosines least_cosine = {Cosine::FromRaw(-(int64_t{1} << 31)), Cosine()};
  const auto mean =
      MeanCosines::Of<3>({corner, corner, corner}, {least_cosine, least_cosine, least_cosine});
  EXPECT_EQ(mean->n_dot_l, Cosine::Round(-1 / std::sqrt(3)));
  EXPECT_EQ(mean->n_dot_h_or_v.raw(), 0);
}

}  // namespace
}  // namespace shading
